import { useEffect, useState } from "react";

import { certifyBlock } from "../api/certificateCommands";
import { Refused } from "../api/http";
import type { BlockCertificateView, MeasuredBlock, Problem } from "../api/wire";
import { useSettled } from "../controls/useSettled";

interface Answer {
  asked: string;
  made: BlockCertificateView | null;
  problem: Problem | null;
}

/** The certificate of what is filled in, once that rests, or why there is none. */
export function useCertificate(measured: MeasuredBlock | null) {
  const text = measured ? JSON.stringify(measured) : "";
  const settled = useSettled(text);
  const [answer, setAnswer] = useState<Answer | null>(null);
  useEffect(() => {
    if (!settled) return;
    let wanted = true;
    certifyBlock(JSON.parse(settled) as MeasuredBlock).then(
      (made) => wanted && setAnswer({ asked: settled, made, problem: null }),
      (error: unknown) => {
        // the lost connection has its own banner
        if (wanted && error instanceof Refused) setAnswer({ asked: settled, made: null, problem: error.problem });
      },
    );
    return () => {
      wanted = false;
    };
  }, [settled]);
  const now = answer?.asked === text ? answer : null;
  return { made: now?.made ?? null, problem: now?.problem ?? null };
}
