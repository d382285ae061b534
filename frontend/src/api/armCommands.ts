import { t } from "../state/language";
import { getState, setState } from "../state/store";
import { done, newKey } from "./commands";
import { post, postOnce } from "./http";
import type { ArmView } from "./wire";

function put(view: ArmView | null): void {
  if (view) setState({ arm: view });
}

export async function sendArm(name: string, args: Record<string, unknown> = {}): Promise<void> {
  const command = { name, args, rev: getState().arm?.rev ?? 0, key: newKey() };
  await done(
    async () => put(await postOnce<ArmView>("/api/arm/command", command)),
    t("ui-the-action-was-not-confirmed"),
  );
}

export async function startArm(purpose: ArmView["purpose"]): Promise<void> {
  await done(async () => put(await post<ArmView>("/api/arm/start", { purpose })), t("ui-the-session-was-not-started"));
}
