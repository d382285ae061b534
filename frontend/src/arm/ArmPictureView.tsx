import type { ArmView } from "../api/wire";
import styles from "./ArmPictureView.module.css";
import { History } from "./History";
import { JointBars } from "./JointBars";
import { ResultView } from "./ResultView";
import { RunCharts } from "./RunCharts";
import { SeatList } from "./SeatList";
import { TipPicture } from "./TipPicture";

/** The apparent motion of the tip in one seat; between seats, the results so far. */
export function ArmPictureView({ view }: { view: ArmView }) {
  const { picture } = view;
  if (view.purpose === "tip" && view.step !== "seat") return <TipPicture picture={picture} />;
  if (picture.result) return <ResultView result={picture.result} id={view.session_id} />;
  if (view.step === "seat")
    return view.purpose !== "identify" ? (
      <History of={view.purpose === "tip" ? "tip" : "arm"} />
    ) : (
      <SeatList seats={picture.seats} />
    );
  return (
    <div className={styles.picture}>
      <RunCharts picture={picture} touching={view.artefact.kind === "sphere"} />
      <JointBars joints={picture.joints} />
    </div>
  );
}
