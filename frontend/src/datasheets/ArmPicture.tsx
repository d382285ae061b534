import { useEffect, useRef, useState } from "react";

import { readJoints } from "../api/datasheetCommands";
import type { ConnectedArmView } from "../api/wire";
import rows from "../controls/List.module.css";
import { t } from "../state/language";
import { useLive } from "../state/store";
import { ArmDrawing } from "./ArmDrawing";
import { type Box, boxOf, type Chain, chainOf } from "./chain";
import styles from "./Datasheets.module.css";

const LOOK_MS = 200;

interface ArmPictureProps {
  document: Record<string, unknown>;
  /** The connected one, whose joints turn the drawing if it has as many. */
  arm: ConnectedArmView | null;
}

/** An arm as its numbers say, as far as they are entered. */
export function ArmPicture({ document, arm }: ArmPictureProps) {
  const joints = Array.isArray(document.joints) ? (document.joints as { a_mm?: number; d_mm?: number }[]) : [];
  const count = joints.length;
  const hasLengths = joints.some(({ a_mm, d_mm }) => a_mm || d_mm);
  const q_deg = useJoints(count > 0 && arm?.joint_count === count);
  const chain = chainOf(document, q_deg);
  const room = useRoom(JSON.stringify(document), chain);
  if (!chain || !room || (count > 0 && !hasLengths)) return null;
  return (
    <figure className={styles.drawing} data-live={q_deg !== null || undefined}>
      <ArmDrawing chain={chain} room={room} label={t("ui-drawing-of-the-datasheet")} />
      {count > 0 && (
        <figcaption className={rows.detail}>
          {q_deg && arm ? t("ui-drawn-as-the-arm-stands", { name: arm.name }) : t("ui-drawn-with-joints-at-zero")}
        </figcaption>
      )}
    </figure>
  );
}

/** The box about an arm wherever it has been since its numbers changed, so that moving does not zoom. */
function useRoom(numbers: string, chain: Chain | null): Box | null {
  const before = useRef<{ numbers: string; box: Box } | null>(null);
  if (!chain) return null;
  const box = boxOf(chain, before.current?.numbers === numbers ? before.current.box : null);
  before.current = { numbers, box };
  return box;
}

/** The angles of the connected arm's joints, again and again; null while they are not known. */
function useJoints(wanted: boolean): number[] | null {
  const live = useLive((s) => s.connection === "live");
  const [q_deg, setJoints] = useState<number[] | null>(null);
  useEffect(() => {
    if (!wanted || !live) return;
    let over = false;
    let timer = 0;
    const look = async () => {
      const now = await readJoints().catch(() => null); // the lost connection has its own banner
      if (over) return;
      setJoints(now?.joints_deg.length ? now.joints_deg : null);
      timer = window.setTimeout(look, LOOK_MS);
    };
    void look();
    return () => {
      over = true;
      clearTimeout(timer);
      setJoints(null);
    };
  }, [wanted, live]);
  return q_deg;
}
