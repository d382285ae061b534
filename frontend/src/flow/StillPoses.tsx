import { useState } from "react";

import type { Picture } from "../api/types";
import { PoseView } from "../image/PoseView";
import { useLook } from "../state/useLook";
import { LinePanel } from "./LinePanel";

/** The poses taken so far; shows the newest one until another is selected. */
export function StillPoses({ picture }: { picture: Extract<Picture, { kind: "still" }> }) {
  const [selection, setSelection] = useState({ pose: picture.shown, newest: picture.shown });
  const show = (pose: number) => setSelection({ pose, newest: picture.shown });
  useLook(show);
  const pose = selection.newest === picture.shown ? selection.pose : picture.shown;
  return (
    <>
      <PoseView poses={picture.poses} selected={pose} onShow={show} />
      {picture.line && <LinePanel line={picture.line} />}
    </>
  );
}
