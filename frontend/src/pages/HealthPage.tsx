import { useCallback, useEffect, useState } from "react";

import { get } from "../api/http";
import type { HealthView } from "../api/wire";
import rows from "../controls/List.module.css";
import { Banners } from "../frame/Banners";
import { Checks } from "../health/Checks";
import { LogList } from "../health/LogList";
import { Maintenance } from "../health/Maintenance";
import { MetricsTokens } from "../health/MetricsTokens";
import { Notifications } from "../health/Notifications";
import { t } from "../state/language";
import { useLive } from "../state/store";
import styles from "./RecordsPage.module.css";

const AGAIN_MS = 3000;

/** The state of the station, and its maintenance. */
export function HealthPage() {
  const role = useLive((s) => s.session?.you?.role);
  const live = useLive((s) => s.connection === "live");
  const [view, setView] = useState<HealthView | null>(null);
  const read = useCallback(async () => {
    try {
      setView(await get<HealthView>("/api/health"));
    } catch {
      // the lost connection has its own banner
    }
  }, []);
  useEffect(() => {
    if (!live) return;
    void read();
    const timer = setInterval(() => void read(), AGAIN_MS);
    return () => clearInterval(timer);
  }, [live, read]);
  const admin = role === "admin";
  const operator = admin || role === "operator";
  return (
    <main className={styles.page}>
      <div className={styles.records} tabIndex={0}>
        {view ? <Checks health={view.health} /> : <p className={rows.empty}>{t("ui-checking-the-station")}</p>}
        {view && <Maintenance backup={view.backup} admin={admin} operator={operator} onChange={read} />}
        <Notifications admin={admin} />
        {admin && <MetricsTokens />}
        {operator && <LogList />}
      </div>
      <Banners />
    </main>
  );
}
