import { useEffect } from "react";

import styles from "./App.module.css";
import { ArmQuestion } from "./frame/ArmQuestion";
import { Rail } from "./frame/Rail";
import { StatusLine } from "./frame/StatusLine";
import { TopBar } from "./frame/TopBar";
import { ArmPage } from "./pages/ArmPage";
import { CalibratePage } from "./pages/CalibratePage";
import { DatasheetsPage } from "./pages/DatasheetsPage";
import { DevicesPage } from "./pages/DevicesPage";
import { EntrancePage } from "./pages/EntrancePage";
import { HealthPage } from "./pages/HealthPage";
import { HomePage } from "./pages/HomePage";
import { PeoplePage } from "./pages/PeoplePage";
import { PerformancePage } from "./pages/PerformancePage";
import { RecordsPage } from "./pages/RecordsPage";
import { ReferencePage } from "./pages/ReferencePage";
import { ScanPage } from "./pages/ScanPage";
import { SettingsPage } from "./pages/SettingsPage";
import { SupervisePage } from "./pages/SupervisePage";
import { VerifyPage } from "./pages/VerifyPage";
import { t, useLanguage } from "./state/language";
import { TITLES, usePage } from "./state/router";
import { useLive } from "./state/store";
import { useUnits } from "./state/units";

const PAGE = {
  home: HomePage,
  calibrate: CalibratePage,
  verify: VerifyPage,
  performance: PerformancePage,
  scan: ScanPage,
  arm: ArmPage,
  records: RecordsPage,
  supervise: SupervisePage,
  health: HealthPage,
  settings: SettingsPage,
  datasheets: DatasheetsPage,
  devices: DevicesPage,
  people: PeoplePage,
  docs: ReferencePage,
};

export function App() {
  const language = useLanguage();
  const units = useUnits();
  const chosen = usePage();
  const replays = useLive((s) => s.replay !== null);
  // nothing is to be done at a replay: its first page is the cloud
  const page = replays && chosen === "home" ? "scan" : chosen;
  const Page = PAGE[page];
  const session = useLive((s) => s.session);
  const title = `${t(TITLES[page])} · Crenel`;
  useEffect(() => {
    document.title = title;
  }, [title]);
  if (session && !session.you) return <EntrancePage session={session} />;
  // a kiosk screen has no controls: the page fills it
  if (session?.you?.kiosk) return <SupervisePage key={`${language} ${units}`} />;
  return (
    <div className={styles.frame}>
      <TopBar page={page} />
      <Rail page={page} />
      {/* a page loads again in another language or unit, for it has loaded texts */}
      <Page key={`${language} ${units}`} />
      <StatusLine />
      <ArmQuestion />
    </div>
  );
}
