import { getState, setState } from "../state/store";
import { get, post, Refused } from "./http";
import type { Activity, ArmUse } from "./wire";

/** The user left the arm to the activity that has it: nothing was done, and nothing is to be said. */
export class LeftAlone extends Error {}

/** Acts; if another activity has the arm, asks whether it is to be ended, and then acts again. */
export async function withArm<T>(act: () => Promise<T>): Promise<T> {
  for (;;) {
    try {
      return await act();
    } catch (error) {
      if (!(error instanceof Refused) || error.problem.code !== "arm-in-use") throw error;
    }
    const use = await get<ArmUse>("/api/activity");
    setState({ activity: use });
    if (use.activity) await end(use.activity);
  }
}

async function end(activity: Activity): Promise<void> {
  if (!(await isToEnd(activity))) throw new LeftAlone();
  try {
    await post("/api/activity/end", { id: activity.id });
  } catch (error) {
    // another one has the arm by now: the next answer asks about that
    if (!(error instanceof Refused) || error.problem.code !== "arm-in-use") throw error;
  }
}

/** Asked once: a later question replaces an earlier one, which is then answered with no. */
function isToEnd(activity: Activity): Promise<boolean> {
  getState().armQuestion?.answer(false);
  return new Promise((resolve) => {
    const answer = (isEnded: boolean) => {
      setState({ armQuestion: null });
      resolve(isEnded);
    };
    setState({ armQuestion: { activity, answer } });
  });
}
