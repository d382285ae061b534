import { useEffect } from "react";

import styles from "./App.module.css";
import { Rail } from "./frame/Rail";
import { StatusLine } from "./frame/StatusLine";
import { TopBar } from "./frame/TopBar";
import { ArmPage } from "./pages/ArmPage";
import { CalibratePage } from "./pages/CalibratePage";
import { HomePage } from "./pages/HomePage";
import { RecordsPage } from "./pages/RecordsPage";
import { ScanPage } from "./pages/ScanPage";
import { SettingsPage } from "./pages/SettingsPage";
import { TITLES, usePage } from "./state/router";

const PAGE = { home: HomePage, calibrate: CalibratePage, scan: ScanPage, arm: ArmPage, records: RecordsPage, settings: SettingsPage };

export function App() {
  const page = usePage();
  const Page = PAGE[page];
  useEffect(() => {
    document.title = `${TITLES[page]} · Crenel`;
  }, [page]);
  return (
    <div className={styles.frame}>
      <TopBar page={page} />
      <Rail page={page} />
      <Page />
      <StatusLine />
    </div>
  );
}
