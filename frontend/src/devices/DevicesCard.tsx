import { type DeviceKind, describeArm, describeCamera, removeDevice } from "../api/deviceCommands";
import type { DevicesView, StationDevice, UndescribedArm } from "../api/wire";
import { MainAct } from "../controls/Actions";
import { CardHead } from "../controls/CardHead";
import { PressButton } from "../controls/PressButton";
import { QualityMark } from "../controls/QualityMark";
import card from "../controls/Section.module.css";
import { t } from "../state/language";
import { go } from "../state/router";
import { useLive } from "../state/store";
import styles from "./Devices.module.css";
import { driverTitle, kindTitle } from "./names";

interface DevicesCardProps {
  view: DevicesView;
  /** The kind of device that was just saved. */
  saved: DeviceKind | null;
  onSearch: () => Promise<void>;
  onView: (view: DevicesView | null) => void;
}

/** The devices in use, and what a search could not look at. */
export function DevicesCard({ view, saved, onSearch, onView }: DevicesCardProps) {
  const title = saved === "arm" ? t("ui-the-arm-is-connected") : t("ui-the-camera-is-connected");
  return (
    <>
      {saved ? (
        <div role="status" data-verdict>
          <CardHead title={title} text={t("ui-saved-in-file-used-from-now-on", { file: view.file })} />
        </div>
      ) : (
        <CardHead title={t("ui-devices")} text={t("ui-choose-a-device-and-try-it")} />
      )}
      {saved && (
        <MainAct>
          <PressButton free kind="primary" onPress={() => go("home")}>
            {t("ui-continue-to-home")}
          </PressButton>
        </MainAct>
      )}
      {view.undescribed && <LineQuestion onView={onView} />}
      {view.undescribed_arm && <ArmDatasheet arm={view.undescribed_arm} onView={onView} />}
      <section className={card.section} aria-labelledby="used">
        <h2 id="used" className={card.heading}>
          {t("ui-this-station-uses")}
        </h2>
        {view.devices.map((device) => (
          <Used key={`${device.kind} ${device.label}`} device={device} view={view} onView={onView} />
        ))}
      </section>
      {view.searching ? (
        <p className={styles.searching} role="status">
          {t("ui-searching")}
        </p>
      ) : (
        <PressButton free onPress={onSearch}>
          {t("ui-search-again")}
        </PressButton>
      )}
      {view.problems.length > 0 && (
        <ul className={styles.problems} aria-label={t("ui-what-is-missing")}>
          {view.problems.map((problem) => (
            <li key={problem.text}>
              <QualityMark quality="attention" size="1.25rem" />
              <div>
                <p className={styles.name}>{problem.text}</p>
                <p className={styles.remedy}>{problem.remedy}</p>
              </div>
            </li>
          ))}
        </ul>
      )}
    </>
  );
}

/** All that the datasheet of a new camera needs from a person. */
function LineQuestion({ onView }: { onView: DevicesCardProps["onView"] }) {
  const answer = (axis: "u" | "v") => async () => onView(await describeCamera(axis));
  return (
    <section className={card.section} aria-labelledby="line">
      <h2 id="line" className={card.heading}>
        {t("ui-how-does-the-laser-line-run")}
      </h2>
      <div className={styles.answers}>
        <PressButton free onPress={answer("u")}>
          <LineDrawing path="M4 20 44 12" />
          {t("ui-from-left-to-right")}
        </PressButton>
        <PressButton free onPress={answer("v")}>
          <LineDrawing path="M20 2 28 30" />
          {t("ui-from-top-to-bottom")}
        </PressButton>
      </div>
      <p className={styles.note}>{t("ui-new-camera-gets-its-datasheet")}</p>
    </section>
  );
}

/** An arm that reports poses says all that its datasheet needs; of another, the owner has the model. */
function ArmDatasheet({ arm, onView }: { arm: UndescribedArm; onView: DevicesCardProps["onView"] }) {
  const write = async () => onView(await describeArm());
  const joints = arm.joint_count;
  return (
    <section className={card.section} aria-labelledby="arm">
      <h2 id="arm" className={card.heading}>
        {t("ui-the-arm-has-no-datasheet")}
      </h2>
      {joints === 0 && (
        <PressButton free onPress={write}>
          {t("ui-write-the-datasheet-of-the-arm")}
        </PressButton>
      )}
      {joints > 0 && (
        <PressButton free kind="primary" onPress={() => go("datasheets", "new/arm")}>
          {t("ui-enter-the-model")}
        </PressButton>
      )}
      <p className={styles.note}>
        {joints === 0 ? t("ui-arm-of-poses-needs-no-more") : t("ui-arm-needs-its-model", { joints })}
      </p>
    </section>
  );
}

function LineDrawing({ path }: { path: string }) {
  return (
    <svg viewBox="0 0 48 32" className={styles.drawing} aria-hidden="true">
      <rect x="1" y="1" width="46" height="30" rx="3" />
      <path d={path} />
    </svg>
  );
}

const QUALITIES = { absent: "attention", connected: "good", connecting: "attention", lost: "bad", off: "bad" } as const;

function Used({
  device,
  view,
  onView,
}: {
  device: StationDevice;
  view: DevicesView;
  onView: DevicesCardProps["onView"];
}) {
  const { kind, state, label, driver, simulated } = device;
  const replays = useLive((s) => s.replay !== null);
  const none = replays ? t("ui-from-the-recording") : t("ui-none");
  const name = simulated ? t("ui-simulated") : label || (driver ? driverTitle(view, kind, driver) : none);
  const remove = async () => onView(await removeDevice(kind));
  return (
    <div className={styles.used}>
      <QualityMark quality={QUALITIES[state.state]} size="1.25rem" />
      <div className={styles.what}>
        <p className={styles.name}>
          {kindTitle(kind)}: {name}
        </p>
        <p className={styles.note}>{state.text}</p>
        {view.demonstration && !simulated && (
          <PressButton kind="quiet" onPress={remove}>
            {t("ui-use-the-simulated-one-again")}
          </PressButton>
        )}
      </div>
    </div>
  );
}
