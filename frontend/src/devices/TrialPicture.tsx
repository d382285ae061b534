import { useEffect, useRef, useState } from "react";

import { trialPicture } from "../api/deviceCommands";
import type { TrialView } from "../api/wire";
import { measured } from "../controls/lengths";
import { QualityMark } from "../controls/QualityMark";
import { type Readout, Readouts } from "../controls/Readouts";
import { t } from "../state/language";
import { stampsText } from "../state/stamps";
import styles from "./Devices.module.css";
import { JointDials } from "./JointDials";

/** What the tried device sends: the camera's picture or the arm's joints, and how well it arrives. */
export function TrialPicture({ trial }: { trial: TrialView }) {
  return (
    <>
      <div className={styles.stage}>
        {trial.kind === "sensor" ? <Picture trial={trial} /> : <JointDials trial={trial} />}
      </div>
      <Readouts wrap readouts={readouts(trial)} />
      {[trial.loss_text, trial.picture_text].filter(Boolean).map((text) => (
        <p key={text} className={styles.warning} role="status" data-quality="attention">
          <QualityMark quality="attention" size="1.5rem" />
          {text}
        </p>
      ))}
    </>
  );
}

/** The newest picture; the one before stays until it is complete. */
function Picture({ trial }: { trial: TrialView }) {
  const [shown, setShown] = useState("");
  const loading = useRef(false);
  const next = trial.picture === null ? "" : trialPicture(trial);
  useEffect(() => {
    if (!next || loading.current) return;
    loading.current = true;
    const image = new Image();
    image.onload = () => {
      loading.current = false;
      setShown(next);
    };
    image.onerror = () => {
      loading.current = false;
    };
    image.src = next;
  }, [next]);
  if (!shown || trial.state === "failed" || trial.state === "ended") return <Waiting trial={trial} />;
  return <img className={styles.image} src={shown} alt={t("ui-live-picture-of-the-tried-camera")} />;
}

/** Instead of data: that it is being opened, or why there are none. */
export function Waiting({ trial }: { trial: TrialView }) {
  const failed = trial.state === "failed";
  if (!failed && trial.state !== "ended") {
    return <p className={styles.waiting}>{trial.text || t("ui-opening-the-device")}</p>;
  }
  const quality = failed ? "bad" : "attention";
  return (
    <p className={styles.failure} role="alert" data-quality={quality}>
      <QualityMark quality={quality} size="1.5rem" />
      {trial.text}
    </p>
  );
}

function readouts(trial: TrialView): Readout[] {
  const { kind, rate_hz, lost, corrupt, stamps, width_px, height_px, exposure_us, exposure_range_us } = trial;
  const sound = (count: number): Pick<Readout, "value" | "quality"> =>
    stamps ? { value: String(count), quality: count ? "attention" : "good" } : { value: "–" };
  const rows: Readout[] = [
    { label: t("ui-rate"), value: rate_hz === null ? "–" : measured(rate_hz, "Hz", rate_hz < 100 ? 1 : 0) },
    { label: t("ui-lost-records"), ...sound(lost) },
    { label: t("ui-corrupt-records"), ...sound(corrupt) },
    {
      label: t("ui-time-stamps"),
      value: stampsText(stamps),
      ...(stamps === "arrival" && { note: t("ui-stamps-arrival-note") }),
    },
  ];
  if (kind === "arm") return rows;
  const range = exposure_range_us;
  return [
    ...rows,
    { label: t("ui-picture-size"), value: width_px === null ? "–" : `${width_px} × ${height_px}`, unit: "px" },
    {
      label: t("ui-exposure"),
      value: exposure_us === null ? "–" : measured(exposure_us, "µs"),
      note: range
        ? t("ui-from-to", { from: measured(range[0], "µs"), to: measured(range[1], "µs") })
        : t("ui-set-at-the-camera"),
    },
  ];
}
