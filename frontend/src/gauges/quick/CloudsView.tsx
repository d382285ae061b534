import { sendCommand } from "../../api/guideCommands";
import type { CloudLine, VerifyPicture } from "../../api/wire";
import { measured, signedLength } from "../../controls/lengths";
import { PressButton } from "../../controls/PressButton";
import type { PlainId } from "../../messages/text";
import { t } from "../../state/language";
import styles from "./CloudsView.module.css";
import { DeviationMap } from "./DeviationMap";
import { LiveScan } from "./LiveScan";
import { displayedOf } from "./verification";

/** The cloud being scanned, or the newest one's map, and every cloud with what it shows. */
export function CloudsView({ picture, busy }: { picture: VerifyPicture; busy: boolean }) {
  const { clouds } = displayedOf(picture);
  const state = picture.scanning
    ? "scanning"
    : picture.clouds.some((cloud) => cloud.state === "measuring")
      ? "measuring"
      : clouds.length > 0
        ? "done"
        : "before";
  return (
    <div className={styles.view}>
      <div className={styles.picture}>
        <LiveScan shape={picture.shape} state={state} />
        {state === "done" && (
          <div className={styles.map}>
            <DeviationMap clouds={clouds} shape={picture.shape ?? "plane"} />
          </div>
        )}
      </div>
      {picture.clouds.length > 0 && (
        <ul className={styles.list} aria-label={t("ui-clouds")}>
          {picture.clouds.map((cloud) => (
            <Row key={cloud.number} cloud={cloud} busy={busy} />
          ))}
        </ul>
      )}
    </div>
  );
}

const STATES: Record<CloudLine["state"], PlainId | null> = {
  scanning: "ui-being-scanned",
  measuring: "ui-being-measured",
  good: null,
  refused: "ui-unusable",
  aside: "ui-excluded",
};

function Row({ cloud, busy }: { cloud: CloudLine; busy: boolean }) {
  const { number, state } = cloud;
  const title = STATES[state];
  const idle = !busy && state !== "scanning" && state !== "measuring";
  return (
    <li className={styles.row} data-state={state}>
      <div className={styles.what}>
        <p className={styles.name}>
          {t("ui-cloud-n", { n: number })}
          {title && <span className={styles.state}>{t(title)}</span>}
        </p>
        <p className={styles.detail}>
          {cloud.text || (cloud.points ? t("ui-n-points", { n: cloud.used || cloud.points }) : "")}
        </p>
      </div>
      <Figures cloud={cloud} />
      {idle && state !== "refused" && (
        <PressButton
          kind="quiet"
          onPress={() => sendCommand("verify", state === "aside" ? "restore_cloud" : "void_cloud", { number })}
        >
          {state === "aside" ? t("ui-include") : t("ui-exclude")}
        </PressButton>
      )}
    </li>
  );
}

function Figures({ cloud }: { cloud: CloudLine }) {
  const figures: [PlainId, string | null][] = [
    ["ui-rms", cloud.rms_um === null ? null : measured(cloud.rms_um, "µm")],
    ["ui-angle-lowercase", cloud.angle_arcsec === null ? null : measured(cloud.angle_arcsec, "″")],
    ["ui-z-error", cloud.z_error_um === null ? null : signedLength(cloud.z_error_um, "µm")],
    ["ui-radius-error-lowercase", cloud.radius_error_um === null ? null : signedLength(cloud.radius_error_um, "µm")],
    ["ui-centre-error-lowercase", cloud.centre_error_um === null ? null : measured(cloud.centre_error_um, "µm")],
  ];
  return (
    <dl className={styles.figures}>
      {figures.map(
        ([name, value]) =>
          value && (
            <div key={name}>
              <dt>{t(name)}</dt>
              <dd>{value}</dd>
            </div>
          ),
      )}
    </dl>
  );
}
