import type { CalibrationSummary, DeviceState, Home } from "../api/wire";
import { MainAct } from "../controls/Actions";
import { CardHead } from "../controls/CardHead";
import { Findings } from "../controls/Findings";
import { lengthFigures, unitOf } from "../controls/lengths";
import { PressButton } from "../controls/PressButton";
import { QualityMark } from "../controls/QualityMark";
import { POINT_DECIMALS } from "../controls/uncertainty";
import { Layout } from "../frame/Layout";
import { PreparationList } from "../home/PreparationList";
import { TemperatureField } from "../home/TemperatureField";
import { ValidityList } from "../home/ValidityList";
import { startDemonstration } from "../state/demonstration";
import { t } from "../state/language";
import { go } from "../state/router";
import { useLive } from "../state/store";
import styles from "./HomePage.module.css";

/** What is valid, what is due, what to do next. */
export function HomePage() {
  const home = useLive((s) => s.home);
  if (!home)
    return <Layout picture={null} card={<CardHead title={t("ui-home")} text={t("ui-waiting-for-the-station")} />} />;
  return (
    <Layout
      picture={
        <div className={styles.home}>
          {home.calibration && <Active calibration={home.calibration} lacksLaser={home.lacks_laser} />}
          {home.preparation.length > 0 ? (
            <PreparationList steps={home.preparation} next={home.next.label} />
          ) : (
            <ValidityList checks={home.checks} next={home.next.label} />
          )}
        </div>
      }
      card={<Next home={home} />}
    />
  );
}

function Active({ calibration, lacksLaser }: { calibration: CalibrationSummary; lacksLaser: boolean }) {
  const devices = [
    t("ui-arm-serial", { serial: calibration.arm_serial }),
    t("ui-sensor-serial", { serial: calibration.sensor_serial }),
    t("ui-object-serial", { serial: calibration.object_serial }),
  ];
  return (
    <div>
      <p className={styles.label}>
        <QualityMark quality={calibration.verdict} /> {t("ui-in-use-name", { name: calibration.name })}
      </p>
      <p className={styles.value}>
        {lengthFigures(calibration.total_um, "µm", POINT_DECIMALS)} <span>{unitOf("µm")}</span>
      </p>
      <p className={styles.note}>
        {t(lacksLaser ? "ui-uncertainty-of-a-point-in-view" : "ui-standard-uncertainty-of-a-scanned-point-lowercase")} ·{" "}
        {devices.join(" · ")}
      </p>
    </div>
  );
}

function isMissing(device?: DeviceState): boolean {
  return device?.state === "absent" || device?.state === "connecting";
}

function Next({ home }: { home: Home }) {
  const { next } = home;
  const admin = useLive((s) => s.session?.you?.role === "admin");
  const running = useLive((s) => s.demonstration?.running ?? false);
  const missing = useLive((s) => isMissing(s.devices?.arm) || isMissing(s.devices?.sensor));
  return (
    <>
      {/* on a phone it is read first, as a verdict is */}
      <div data-verdict>
        <CardHead title={t("ui-what-to-do-next")} text={next.text} />
      </div>
      <MainAct>
        <PressButton free kind="primary" onPress={() => go(next.page)}>
          {next.label}
        </PressButton>
      </MainAct>
      {home.station.has_simulation && !running && (
        <PressButton onPress={startDemonstration}>{t("ui-let-the-simulated-operator-do-everything")}</PressButton>
      )}
      {admin && next.page !== "devices" && (home.station.simulated || missing) && (
        <PressButton free onPress={() => go("devices")}>
          {home.station.simulated ? t("ui-connect-your-own-devices") : t("ui-devices")}
        </PressButton>
      )}
      <Findings findings={home.findings} />
      <TemperatureField celsius={home.temperature_c} />
    </>
  );
}
