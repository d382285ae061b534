import type { CalibrationSummary, Home } from "../api/types";
import { Layout } from "../frame/Layout";
import { CardHead } from "../parts/CardHead";
import { EmptyState } from "../parts/EmptyState";
import { Findings } from "../parts/Findings";
import { days, figures, moment } from "../parts/format";
import { PressButton } from "../parts/PressButton";
import { QualityMark } from "../parts/QualityMark";
import { go } from "../state/router";
import { useLive } from "../state/store";
import styles from "./HomePage.module.css";

/** What is valid, what is due, what to do next. */
export function HomePage() {
  const home = useLive((s) => s.home);
  if (!home) return <Layout picture={null} card={<CardHead title="Home" text="Waiting for the station." />} />;
  const picture = home.calibration ? (
    <Active calibration={home.calibration} />
  ) : (
    <EmptyState
      title="No calibration yet"
      text="Once the sensor is calibrated, its uncertainty, its age and the devices it belongs to stand here."
    />
  );
  return <Layout picture={picture} card={<Next home={home} />} />;
}

function Active({ calibration }: { calibration: CalibrationSummary }) {
  const facts: [string, string][] = [
    ["Accepted", moment(calibration.accepted_at)],
    ["Age", days(calibration.age_days)],
    ["Arm", calibration.arm_serial],
    ["Sensor", calibration.sensor_serial],
    ["Object", calibration.object_serial],
  ];
  return (
    <div className={styles.active}>
      <p className={styles.label}>
        <QualityMark quality={calibration.verdict} /> In use: {calibration.name}
      </p>
      <p className={styles.value}>
        {figures(calibration.total_um)} <span>µm</span>
      </p>
      <p className={styles.note}>standard uncertainty of a scanned point, k = 1</p>
      <dl className={styles.facts}>
        {facts.map(([name, value]) => (
          <div key={name}>
            <dt>{name}</dt>
            <dd>{value}</dd>
          </div>
        ))}
      </dl>
    </div>
  );
}

function Next({ home }: { home: Home }) {
  const { next } = home;
  return (
    <>
      <CardHead title="What to do next" text={next.text} />
      <PressButton free kind="primary" onPress={() => go(next.page)}>
        {next.label}
      </PressButton>
      <Findings findings={home.findings} />
    </>
  );
}
