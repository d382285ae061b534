import type { RecordedCalibration } from "../api/wire";
import { BigNumber } from "../controls/BigNumber";
import { CardHead } from "../controls/CardHead";
import { Download } from "../controls/Download";
import { Findings } from "../controls/Findings";
import { newFindings } from "../controls/findings";
import { moment } from "../controls/format";
import { measured } from "../controls/lengths";
import { PressButton } from "../controls/PressButton";
import { Reports } from "../controls/Reports";
import { POINT_DECIMALS } from "../controls/uncertainty";
import { Layout } from "../frame/Layout";
import { ResultPicture } from "../result/ResultPicture";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import { asSent } from "../state/localized";
import { go } from "../state/router";
import { useLive } from "../state/store";
import { useRead } from "../state/useRead";
import styles from "./CalibrationRecord.module.css";

/** One accepted calibration: its result and its reports. */
export function CalibrationRecord({ id }: { id: string }) {
  const inUse = useLive((s) => s.home?.calibration?.id ?? "");
  const { value, failed } = useRead<RecordedCalibration>(`/api/calibrations/${id}`, inUse);
  if (!value) {
    const text = failed ? t("ui-cannot-displayed-files-missing-data-folder") : t("ui-loading-the-calibration");
    return <Layout picture={null} card={<Head title={t("ui-calibration")} text={text} />} />;
  }
  const { summary, picture, findings } = value;
  return (
    <Layout
      picture={<ResultPicture picture={picture} />}
      card={
        <>
          <Head
            title={isolated(summary.name).replaceAll("-", "\u2011")}
            text={summary.active ? t("ui-in-use") : t("ui-no-longer-in-use")}
          />
          <BigNumber
            stored
            verdict
            number={{
              label: t("ui-uncertainty-scanned-point-k-1"),
              value: summary.total_um,
              unit: "µm",
              decimals: POINT_DECIMALS,
              quality: summary.verdict,
              note: picture.result.verdict_text,
            }}
          />
          <div className={styles.files}>
            <Reports of={`/api/calibrations/${summary.id}`} />
            <Download href={`/api/calibrations/${summary.id}/calibration.json`}>JSON</Download>
          </div>
          <Facts record={value} />
          <Findings findings={newFindings(findings, [], [asSent(picture.result).verdict_text])} />
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
          ← {t("ui-all-records")}
        </PressButton>
      </div>
      <CardHead title={title} text={text} />
    </>
  );
}

function Facts({ record: { summary, operator, station, temperature_c } }: { record: RecordedCalibration }) {
  const rows = [
    [t("ui-accepted"), moment(summary.accepted_at)],
    [t("ui-operator"), isolated(operator) || t("ui-not-stated")],
    [t("ui-station"), isolated(station) || t("ui-not-stated")],
    [t("ui-arm"), summary.arm_serial],
    [t("ui-sensor"), summary.sensor_serial],
    [t("ui-object"), summary.object_serial],
    [t("ui-temperature"), temperature_c === null ? t("ui-not-measured") : measured(temperature_c, "°C", 1)],
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
