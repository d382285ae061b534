import type { RecordedCalibration } from "../api/recordTypes";
import { Layout } from "../frame/Layout";
import { BigNumber } from "../parts/BigNumber";
import { CardHead } from "../parts/CardHead";
import { Download } from "../parts/Download";
import { Findings } from "../parts/Findings";
import { figures, moment } from "../parts/format";
import { PressButton } from "../parts/PressButton";
import { Reports } from "../parts/Reports";
import { ResultPicture } from "../result/ResultPicture";
import { isolated } from "../state/isolated";
import { said, t } from "../state/language";
import { go } from "../state/router";
import { useLive } from "../state/store";
import { useRead } from "../state/useRead";
import styles from "./CalibrationRecord.module.css";

/** One accepted calibration: the result again as a picture, and its reports. */
export function CalibrationRecord({ id }: { id: string }) {
  const inUse = useLive((s) => s.home?.calibration?.id ?? "");
  const { value, failed } = useRead<RecordedCalibration>(`/api/calibrations/${id}`, inUse);
  if (!value) {
    const text = failed
      ? t("It cannot be shown: its files are not in the data folder any more, or the station is away.")
      : t("Reading the calibration.");
    return <Layout picture={null} card={<Head title={t("Calibration")} text={text} />} />;
  }
  const { summary, picture, findings } = value;
  return (
    <Layout
      picture={<ResultPicture picture={picture} />}
      card={
        <>
          <Head title={said(summary.name).replaceAll("-", "\u2011")} text={summary.active ? t("It is in use.") : t("It is not in use any more.")} />
          <BigNumber
            kept
            verdict
            number={{
              label: t("Uncertainty of a scanned point (k = 1)"),
              value: summary.total_um,
              unit: "µm",
              decimals: 0,
              quality: summary.verdict,
              note: picture.result.verdict_text,
            }}
          />
          <div className={styles.files}>
            <Reports of={`/api/calibrations/${summary.id}`} />
            <Download href={`/api/calibrations/${summary.id}/calibration.json`}>JSON</Download>
          </div>
          <Facts record={value} />
          <Findings findings={findings.filter(({ text }) => !picture.result.verdict_text.startsWith(text))} />
        </>
      }
    />
  );
}

function Head({ title, text }: { title: string; text: string }) {
  return (
    <>
      <div>
        <PressButton free kind="quiet" onPress={() => go("records")}>
          ← {t("All records")}
        </PressButton>
      </div>
      <CardHead title={title} text={text} />
    </>
  );
}

function Facts({ record: { summary, operator, station, temperature_c } }: { record: RecordedCalibration }) {
  const rows = [
    [t("Accepted"), moment(summary.accepted_at)],
    [t("Operator"), isolated(operator) || t("not stated")],
    [t("Station"), isolated(station) || t("not stated")],
    [t("Arm"), summary.arm_serial],
    [t("Sensor"), summary.sensor_serial],
    [t("Object"), summary.object_serial],
    [t("Temperature"), temperature_c === null ? t("not measured") : `${figures(temperature_c, 1)} °C`],
  ];
  return (
    <dl className={styles.facts}>
      {rows.map(([name, value]) => (
        <div key={name}>
          <dt>{name}</dt>
          <dd>{value}</dd>
        </div>
      ))}
    </dl>
  );
}
