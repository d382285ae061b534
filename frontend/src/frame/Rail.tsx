import { type MouseEvent, useEffect, useRef } from "react";

import {
  ArmIcon,
  CalibrateIcon,
  DatasheetsIcon,
  DevicesIcon,
  HealthIcon,
  HomeIcon,
  PeopleIcon,
  PerformanceIcon,
  RecordsIcon,
  ScanIcon,
  SettingsIcon,
  SuperviseIcon,
  VerifyIcon,
} from "../parts/icons";
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
  const admin = useLive((s) => s.session?.you?.role === "admin");
  return (
    <div className={styles.rail}>
      <nav className={styles.pages} aria-label={t("ui-pages")}>
        {PAGES.filter((to) => admin || !ADMINISTRATION.has(to)).map((to) => (
          <PageLink key={to} to={to} current={to === page} />
        ))}
      </nav>
      <StepList session={session} />
    </div>
  );
}

function PageLink({ to, current }: { to: (typeof PAGES)[number]; current: boolean }) {
  const Icon = ICONS[to];
  const follow = (event: MouseEvent) => {
    if (event.metaKey || event.ctrlKey || event.shiftKey) return;
    event.preventDefault();
    go(to);
  };
  const link = useRef<HTMLAnchorElement>(null);
  // on a phone the pages scroll sideways
  useEffect(() => {
    if (current) link.current?.scrollIntoView({ block: "nearest", inline: "nearest" });
  }, [current]);
  return (
    <a
      ref={link}
      href={pathOf(to)}
      className={styles.page}
      aria-current={current ? "page" : undefined}
      onClick={follow}
    >
      <Icon />
      <span>{t(TITLES[to])}</span>
    </a>
  );
}
