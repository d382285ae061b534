import { applyDelay, findDelay, passForDelay } from "../api/settingsCommands";
import type { StationSettings, Sync } from "../api/wire";
import fields from "../controls/Field.module.css";
import { Findings } from "../controls/Findings";
import { signed } from "../controls/format";
import { measured } from "../controls/lengths";
import { PressButton } from "../controls/PressButton";
import card from "../controls/Section.module.css";
import { quantity } from "../messages/text";
import { t } from "../state/language";
import { useLive } from "../state/store";
import styles from "./Settings.module.css";

/** The delay between arm and camera: determined from a pass over a plane, then applied. */
export function DelaySettings({ settings }: { settings: StationSettings }) {
  const hasOperator = useLive((s) => s.station?.has_simulation ?? false);
  const scanning = useLive((s) => s.scan?.state === "running" || s.scan?.state === "stopping");
  const { delay, delay_applied, finding_delay } = settings;
  return (
    <section className={card.section} aria-labelledby="delay">
      <h2 id="delay" className={card.heading}>
        {t("ui-delay-between-arm-and-camera")}
      </h2>
      {delay ? (
        <>
          <CurrentDelay delay={delay} applied={delay_applied} />
          <Findings findings={settings.delay_findings} />
        </>
      ) : (
        <p className={fields.help}>{t("ui-none-used-determine-scan-flat-plate")}</p>
      )}
      {finding_delay ? (
        <p className={styles.busy}>
          {scanning ? t("ui-simulated-operator-passes-over-plate") : t("ui-determining-the-delay")}
        </p>
      ) : (
        <div className={styles.buttons}>
          {delay && !delay_applied && <PressButton onPress={() => applyDelay(true)}>{t("ui-use-it")}</PressButton>}
          {delay_applied && <PressButton onPress={() => applyDelay(false)}>{t("ui-use-none")}</PressButton>}
          <PressButton onPress={findDelay} disabled={scanning}>
            {t("ui-determine-from-the-last-scan")}
          </PressButton>
          {hasOperator && (
            <PressButton onPress={passForDelay} disabled={scanning}>
              {t("ui-let-the-simulated-operator-do-it")}
            </PressButton>
          )}
        </div>
      )}
    </section>
  );
}

function CurrentDelay({ delay, applied }: { delay: Sync; applied: boolean }) {
  return (
    <>
      <p className={styles.number}>
        {signed(delay.delay_ms, 3)} <span>ms ± {measured(delay.standard_uncertainty_ms, "ms", 3)} (k = 1)</span>
      </p>
      <p className={fields.help}>
        {applied ? t("ui-use-next-scan") : t("ui-determined-not-in-use-yet")}{" "}
        {t("ui-points-about-plane-rms-without", {
          without: delay.rms_without_um == null ? "–" : quantity(delay.rms_without_um, "µm"),
          with: quantity(delay.rms_um, "µm"),
        })}
        {delay.recording && ` (${delay.recording})`}.
      </p>
    </>
  );
}
