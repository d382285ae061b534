import { t } from "../state/language";
import { localized } from "../state/localized";
import { getState, setState } from "../state/store";
import { done, newKey, notifyOfError } from "./commands";
import { post, postOnce } from "./http";
import type { StudyState, VerifyView } from "./wire";

function put(view: VerifyView | null): void {
  if (view) setState({ verify: view });
}

export async function sendVerify(name: string, args: Record<string, unknown> = {}): Promise<void> {
  const command = { name, args, rev: getState().verify?.rev ?? 0, key: newKey() };
  await done(
    async () => put(await postOnce<VerifyView>("/api/verify/command", command)),
    t("ui-the-action-was-not-confirmed"),
  );
}

export async function startVerify(): Promise<void> {
  await done(
    async () => put(await post<VerifyView>("/api/verify/start", {})),
    t("ui-the-verification-was-not-started"),
  );
}

export async function makeStudy(id: string): Promise<StudyState | null> {
  try {
    return localized(await post<StudyState>(`/api/verifications/${id}/study`, {}));
  } catch (error) {
    notifyOfError(error, t("ui-the-clouds-were-not-rebuilt"));
    return null;
  }
}
