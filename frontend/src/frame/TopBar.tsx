import { Mark } from "../controls/icons";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import { type Page, TITLES } from "../state/router";
import { useLive } from "../state/store";
import { usePageSession } from "../state/usePageSession";
import { ControlMenu } from "./ControlMenu";
import { PageMenu } from "./PageMenu";
import { SafetyControls } from "./SafetyControls";
import { Toggles } from "./Toggles";
import styles from "./TopBar.module.css";

export function TopBar({ page }: { page: Page }) {
  const station = useLive((s) => s.station);
  return (
    <header className={styles.bar}>
      <PageMenu page={page} />
      <div className={styles.brand}>
        <Mark />
        <div className={styles.names}>
          <span className={styles.name}>
            <span className={styles.product}>Crenel</span>
            <span className={styles.here}>{t(TITLES[page])}</span>
          </span>
          <span className={styles.station}>
            <span className={styles.called}>{isolated(station?.name ?? "")}</span>
            {station?.simulated && <span className={styles.simulated}>{t("ui-simulated")}</span>}
          </span>
        </div>
      </div>
      <WhereWeAre page={page} />
      <ControlMenu />
      <Toggles />
      <SafetyControls />
    </header>
  );
}

/** The page's name, and which step of its guided session it is; the card says what the step is called. */
function WhereWeAre({ page }: { page: Page }) {
  const session = usePageSession(page);
  if (!session?.running) return <div className={styles.where}>{t(TITLES[page])}</div>;
  const index = session.steps.findIndex((step) => step.id === session.step);
  return (
    <div className={styles.where}>
      <span className={styles.count}>{t("ui-step-of", { n: index + 1, all: session.steps.length })}</span>
      {t(TITLES[page])}
    </div>
  );
}
