import { t } from "../state/language";
import { spoken } from "../state/spoken";
import { clearNotice } from "../state/notices";
import { getState, setState } from "../state/store";
import { newKey, tell } from "./commands";
import { NoAnswer, post } from "./http";
import type { StudyState, VerifyView } from "./verifyTypes";

function put(view: VerifyView | null): void {
  clearNotice();
  if (view) setState({ verify: view });
}

/** Sends once more with the same key when no answer came: the station acts only once. */
export async function sendVerify(name: string, args: Record<string, unknown> = {}): Promise<void> {
  const command = { name, args, rev: getState().verify?.rev ?? 0, key: newKey() };
  const send = () => post<VerifyView>("/api/verify/command", command);
  try {
    put(
      await send().catch((error: unknown) => {
        if (error instanceof NoAnswer) return send();
        throw error;
      }),
    );
  } catch (error) {
    tell(error, t("the action was not confirmed"));
  }
}

export async function startVerify(): Promise<void> {
  try {
    put(await post<VerifyView>("/api/verify/start", {}));
  } catch (error) {
    tell(error, t("the verification was not started"));
  }
}

export async function makeStudy(id: string): Promise<StudyState | null> {
  try {
    return spoken(await post<StudyState>(`/api/verifications/${id}/study`, {}));
  } catch (error) {
    tell(error, t("the clouds were not rebuilt"));
    return null;
  }
}
