import type { MouseEvent } from "react";

import {
  ArmIcon,
  CalibrateIcon,
  DatasheetsIcon,
  DevicesIcon,
  HealthIcon,
  HomeIcon,
  PartIcon,
  PeopleIcon,
  PerformanceIcon,
  RecordsIcon,
  ScanIcon,
  SettingsIcon,
  SuperviseIcon,
  VerifyIcon,
} from "../controls/icons";
import { t } from "../state/language";
import { go, PAGES, type Page, pathOf, TITLES } from "../state/router";
import { useLive } from "../state/store";
import { usePageSession } from "../state/usePageSession";
import styles from "./Rail.module.css";
import { StepList } from "./StepList";

const ICONS = {
  home: HomeIcon,
  calibrate: CalibrateIcon,
  verify: VerifyIcon,
  performance: PerformanceIcon,
  scan: ScanIcon,
  part: PartIcon,
  arm: ArmIcon,
  records: RecordsIcon,
  supervise: SuperviseIcon,
  health: HealthIcon,
  settings: SettingsIcon,
  datasheets: DatasheetsIcon,
  devices: DevicesIcon,
  people: PeopleIcon,
};

/** Pages that only an administrator can use. */
const ADMINISTRATION: ReadonlySet<Page> = new Set(["devices", "people"]);

/** Pages, and under them the steps of the page's guided session while it is on. */
export function Rail({ page }: { page: Page }) {
  const session = usePageSession(page);
  return (
    <div className={styles.rail} data-part="pages">
      <PageLinks page={page} />
      <StepList session={session} />
    </div>
  );
}

export function PageLinks({ page, onGo }: { page: Page; onGo?: () => void }) {
  const admin = useLive((s) => s.session?.you?.role === "admin");
  return (
    <nav className={styles.pages} aria-label={t("ui-pages")}>
      {PAGES.filter((to) => admin || !ADMINISTRATION.has(to)).map((to) => (
        <PageLink key={to} to={to} current={to === page} onGo={onGo} />
      ))}
    </nav>
  );
}

interface PageLinkProps {
  to: (typeof PAGES)[number];
  current: boolean;
  onGo: (() => void) | undefined;
}

function PageLink({ to, current, onGo }: PageLinkProps) {
  const Icon = ICONS[to];
  const follow = (event: MouseEvent) => {
    if (event.metaKey || event.ctrlKey || event.shiftKey) return;
    event.preventDefault();
    go(to);
    onGo?.();
  };
  return (
    <a href={pathOf(to)} className={styles.page} aria-current={current ? "page" : undefined} onClick={follow}>
      <Icon />
      <span>{t(TITLES[to])}</span>
    </a>
  );
}
