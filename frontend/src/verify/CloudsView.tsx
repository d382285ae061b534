import { sendVerify } from "../api/verifyCommands";
import type { CloudLine, VerifyPicture } from "../api/verifyTypes";
import { bound, figures } from "../parts/format";
import { measured, signedLength } from "../parts/lengths";
import { PressButton } from "../parts/PressButton";
import { counted, t, words } from "../state/language";
import styles from "./CloudsView.module.css";
import { DeviationMap } from "./DeviationMap";
import { LiveScan } from "./LiveScan";
import { shownOf } from "./shown";

/** The cloud being scanned, or the newest one's map, and every cloud with what it shows. */
export function CloudsView({ picture, busy }: { picture: VerifyPicture; busy: boolean }) {
  const { clouds } = shownOf(picture);
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
        <ul className={styles.list} aria-label={t("Clouds")}>
          {picture.clouds.map((cloud) => (
            <Row key={cloud.number} cloud={cloud} busy={busy} />
          ))}
        </ul>
      )}
    </div>
  );
}

const STATE: Record<CloudLine["state"], string> = {
  scanning: words("being scanned"),
  measuring: words("being measured"),
  good: "",
  refused: words("of no use"),
  aside: words("set aside"),
};

function Row({ cloud, busy }: { cloud: CloudLine; busy: boolean }) {
  const { number, state } = cloud;
  const idle = !busy && state !== "scanning" && state !== "measuring";
  return (
    <li className={styles.row} data-state={state}>
      <div className={styles.what}>
        <p className={styles.name}>
          {t("Cloud {n}", { n: number })}
          {STATE[state] && <span className={styles.state}>{t(STATE[state])}</span>}
        </p>
        <p className={styles.detail}>{bound(cloud.text || (cloud.points ? counted(cloud.used || cloud.points, "{n} point", "{n} points") : ""))}</p>
      </div>
      <Figures cloud={cloud} />
      {idle && state !== "refused" && (
        <PressButton kind="quiet" onPress={() => sendVerify(state === "aside" ? "restore_cloud" : "void_cloud", { number })}>
          {state === "aside" ? t("Take it back") : t("Set aside")}
        </PressButton>
      )}
    </li>
  );
}

function Figures({ cloud }: { cloud: CloudLine }) {
  const shown: [string, string | null][] = [
    [words("rms"), cloud.rms_um === null ? null : measured(cloud.rms_um, "µm")],
    [words("angle"), cloud.angle_arcsec === null ? null : `${figures(cloud.angle_arcsec)}″`],
    [words("Z error"), cloud.z_error_um === null ? null : signedLength(cloud.z_error_um, "µm")],
    [words("radius error"), cloud.radius_error_um === null ? null : signedLength(cloud.radius_error_um, "µm")],
    [words("centre error"), cloud.centre_error_um === null ? null : measured(cloud.centre_error_um, "µm")],
  ];
  return (
    <dl className={styles.figures}>
      {shown.map(
        ([name, value]) =>
          value && (
            <div key={name}>
              <dt>{t(name)}</dt>
              <dd>{bound(value)}</dd>
            </div>
          ),
      )}
    </dl>
  );
}
