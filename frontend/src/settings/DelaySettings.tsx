import { applyDelay, findDelay, passForDelay } from "../api/settingsCommands";
import type { Delay, StationSettings } from "../api/settingsTypes";
import fields from "../parts/Field.module.css";
import { figures, signed } from "../parts/format";
import { measured } from "../parts/lengths";
import { PressButton } from "../parts/PressButton";
import { t } from "../state/language";
import { useLive } from "../state/store";
import styles from "./Settings.module.css";

/** The constant delay between arm and camera: found from a pass over a plane, then used. */
export function DelaySettings({ settings }: { settings: StationSettings }) {
  const hasHand = useLive((s) => s.station?.has_hand ?? false);
  const scanning = useLive((s) => s.scan?.state === "running" || s.scan?.state === "stopping");
  const { delay, finding_delay } = settings;
  return (
    <section className={styles.section} aria-labelledby="delay">
      <h2 id="delay" className={styles.heading}>
        {t("Delay between arm and camera")}
      </h2>
      {delay ? (
        <Found delay={delay} />
      ) : (
        <p className={fields.help}>
          {t("None is used. To find it, scan a flat plate: go over it, nearer and away again, at least three times, briskly. Stop, then find it here.")}
        </p>
      )}
      {finding_delay ? (
        <p className={styles.busy}>{scanning ? t("The hand passes over the plate.") : t("Looking for the delay.")}</p>
      ) : (
        <div className={styles.buttons}>
          {delay && !delay.applied && <PressButton onPress={() => applyDelay(true)}>{t("Use it")}</PressButton>}
          {delay?.applied && <PressButton onPress={() => applyDelay(false)}>{t("Use none")}</PressButton>}
          <PressButton onPress={findDelay} disabled={scanning}>
            {t("Find it in the last scan")}
          </PressButton>
          {hasHand && (
            <PressButton onPress={passForDelay} disabled={scanning}>
              {t("Let the hand do it")}
            </PressButton>
          )}
        </div>
      )}
    </section>
  );
}

function Found({ delay }: { delay: Delay }) {
  return (
    <>
      <p className={styles.number}>
        {signed(delay.delay_ms, 2)} <span>ms ± {figures(delay.standard_uncertainty_ms, 2)} ms (k = 1)</span>
      </p>
      <p className={fields.help}>
        {delay.applied ? t("In use from the next scan on.") : t("Found, not yet used.")}{" "}
        {t("Points about the plane: {without} rms without it, {with} with it", {
          without: measured(delay.rms_without_um, "µm"),
          with: measured(delay.rms_um, "µm"),
        })}
        {delay.scan && ` (${delay.scan})`}.
      </p>
    </>
  );
}
