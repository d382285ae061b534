import type { DeviceKind } from "../api/deviceCommands";
import type { DevicesView, FoundView } from "../api/wire";
import { ArmIcon, CameraIcon } from "../controls/icons";
import rows from "../controls/List.module.css";
import { PressButton } from "../controls/PressButton";
import { t } from "../state/language";
import styles from "./Devices.module.css";
import { driverTitle } from "./names";

interface DeviceListProps {
  view: DevicesView;
  onTry: (found: FoundView) => Promise<void>;
  onManual: (kind: DeviceKind) => void;
}

/** What was found: cameras and arms, each with its own button. */
export function DeviceList({ view, onTry, onManual }: DeviceListProps) {
  return (
    <div className={styles.list}>
      <Kind kind="sensor" view={view} onTry={onTry} onManual={onManual} />
      <Kind kind="arm" view={view} onTry={onTry} onManual={onManual} />
    </div>
  );
}

function Kind({ kind, view, onTry, onManual }: DeviceListProps & { kind: DeviceKind }) {
  const found = view.found.filter((one) => one.kind === kind);
  const camera = kind === "sensor";
  const title = camera ? t("ui-cameras") : t("ui-arms");
  const none = camera ? t("ui-no-camera-was-found") : t("ui-no-arm-was-found");
  return (
    <section className={styles.kind} aria-label={title}>
      <h2 className={rows.heading}>{title}</h2>
      {found.length === 0 && (
        <p className={styles.none} role="status">
          {view.searched ? none : t("ui-searching")}
        </p>
      )}
      {found.length > 0 && (
        <ul className={styles.rows}>
          {found.map((one) => (
            <Row key={`${one.driver} ${JSON.stringify(one.options)}`} view={view} found={one} onTry={onTry} />
          ))}
        </ul>
      )}
      <PressButton free onPress={() => onManual(kind)}>
        {camera ? t("ui-my-camera-is-not-listed") : t("ui-my-arm-is-not-listed")}
      </PressButton>
    </section>
  );
}

type RowProps = Pick<DeviceListProps, "view" | "onTry"> & { found: FoundView };

function Row({ view, found, onTry }: RowProps) {
  const Icon = found.kind === "sensor" ? CameraIcon : ArmIcon;
  return (
    <li className={styles.row} data-used={found.in_use || undefined}>
      <Icon size="2rem" />
      <div className={styles.what}>
        <p className={styles.name}>{found.title}</p>
        <p className={styles.note}>{driverTitle(view, found.kind, found.driver)}</p>
      </div>
      {found.in_use && <span className={styles.badge}>{t("ui-in-use-badge")}</span>}
      <PressButton free onPress={() => onTry(found)}>
        {found.in_use ? t("ui-show") : t("ui-try")}
      </PressButton>
    </li>
  );
}
