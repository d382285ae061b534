import { useEffect, useState } from "react";

import { newKey } from "../api/commands";
import { designBlock, type SensorNumbers } from "../api/designCommands";
import { NoAnswer, Refused } from "../api/http";
import type { BlockDesignState, Problem } from "../api/wire";
import { useSettled } from "../controls/useSettled";

const ASK_AGAIN_MS = 400;
const NO_ANSWER_MS = 2000;

interface Answer {
  /** The numbers that it is for. */
  asked: string;
  state: BlockDesignState | null;
  problem: Problem | null;
}

/** The block for the numbers of a sensor once they rest, and how far it is; none while they are no numbers. */
export function useBlockDesign(numbers: SensorNumbers | null) {
  const [page] = useState(newKey);
  const text = numbers ? JSON.stringify(numbers) : "";
  const settled = useSettled(text);
  const [answer, setAnswer] = useState<Answer | null>(null);
  const [last, setLast] = useState<BlockDesignState["design"]>(null);
  useEffect(() => {
    if (!settled) return;
    let wanted = true;
    let timer = 0;
    const ask = async () => {
      let again = ASK_AGAIN_MS;
      try {
        const state = await designBlock(page, JSON.parse(settled) as SensorNumbers);
        if (!wanted) return;
        setAnswer({ asked: settled, state, problem: null });
        if (state?.design) {
          setLast(state.design);
          return;
        }
      } catch (error) {
        if (!wanted) return;
        if (error instanceof Refused) {
          setAnswer({ asked: settled, state: null, problem: error.problem });
          return;
        }
        if (!(error instanceof NoAnswer)) throw error;
        again = NO_ANSWER_MS; // the lost connection has its own banner
      }
      timer = window.setTimeout(() => void ask(), again);
    };
    void ask();
    return () => {
      wanted = false;
      window.clearTimeout(timer);
    };
  }, [settled, page]);
  const now = answer?.asked === text ? answer : null;
  return {
    /** The block for these numbers; while there is none, that of the former ones. */
    design: now?.state?.design ?? last,
    isCurrent: Boolean(now?.state?.design),
    problem: now?.problem ?? null,
    share: now?.state?.share ?? 0,
    step: now?.state?.step ?? "",
  };
}
