import { t } from "../state/language";
import { clearNotice } from "../state/notices";
import { getState, setState } from "../state/store";
import type { ArmView } from "./armTypes";
import { newKey, tell } from "./commands";
import { NoAnswer, post } from "./http";

function put(view: ArmView | null): void {
  clearNotice();
  if (view) setState({ arm: view });
}

/** Sends once more with the same key when no answer came: the station acts only once. */
export async function sendArm(name: string, args: Record<string, unknown> = {}): Promise<void> {
  const command = { name, args, rev: getState().arm?.rev ?? 0, key: newKey() };
  const send = () => post<ArmView>("/api/arm/command", command);
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

export async function startArm(purpose: ArmView["purpose"]): Promise<void> {
  try {
    put(await post<ArmView>("/api/arm/start", { purpose }));
  } catch (error) {
    tell(error, t("the session was not started"));
  }
}
