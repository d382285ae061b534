import { useState } from "react";
import { signOut } from "../api/session";
import type { FleetOverview, SignInState } from "../api/wire";
import { Chips } from "../controls/Chips";
import { ChooseLanguage } from "../controls/ChooseLanguage";
import control from "../controls/Control.module.css";
import { timeZone } from "../controls/format";
import { Mark } from "../controls/icons";
import { PressButton } from "../controls/PressButton";
import { Entrance } from "../pages/EntrancePage";
import { addressOf } from "../state/base";
import { isolated } from "../state/isolated";
import { t, useLanguage } from "../state/language";
import { useLive } from "../state/store";
import { AgeingView } from "./AgeingView";
import { useAnswer } from "./answers";
import { CalibrationsTable } from "./CalibrationsTable";
import { DriftView } from "./DriftView";
import styles from "./FleetPage.module.css";
import { RecordSearch } from "./RecordSearch";
import { SpreadTable } from "./SpreadTable";
import { StationList } from "./StationList";

type View = "stations" | "records" | "drift" | "calibrations" | "ageing";
const READ_MS = 5000;

/** All stations: what they do, what they recorded, and how their figures drift. */
export function FleetPage() {
  const language = useLanguage();
  const session = useLive((s) => s.session);
  if (!session) return null;
  if (session.provider && !session.you) return <FleetEntrance key={language} session={session} />;
  return <Views key={language} session={session} />;
}

function FleetEntrance({ session }: { session: SignInState }) {
  return (
    <Entrance session={session}>
      {session.password_page && (
        <a className={control.button} href={addressOf(session.password_page)}>
          {t("ui-fleet-with-the-password")}
        </a>
      )}
    </Entrance>
  );
}

function Views({ session }: { session: SignInState }) {
  const [view, setView] = useState<View>("stations");
  const { value: overview, failed } = useAnswer<FleetOverview>("/api/fleet/overview", READ_MS);
  return (
    <div className={styles.frame}>
      <header className={styles.bar}>
        <Mark size="1.75em" />
        <h1 className={styles.title}>{t("ui-fleet")}</h1>
        <Chips
          label={t("ui-view")}
          value={view}
          onChange={setView}
          options={[
            { value: "stations", label: t("ui-stations") },
            { value: "records", label: t("ui-fleet-records") },
            { value: "drift", label: t("ui-fleet-drift") },
            { value: "calibrations", label: t("ui-fleet-calibrations") },
            { value: "ageing", label: t("ui-fleet-ageing") },
          ]}
        />
        <div className={styles.person}>
          {session.you && (
            <>
              <span>{isolated(session.you.name)}</span>
              <PressButton free kind="quiet" onPress={async () => void (await signOut())}>
                {t("ui-sign-out")}
              </PressButton>
            </>
          )}
          <ChooseLanguage id="fleet-language" />
        </div>
      </header>
      <main className={styles.main} tabIndex={0} aria-label={t("ui-fleet")}>
        <p className={styles.times}>{t("ui-fleet-times", { zone: timeZone() })}</p>
        {(failed || overview?.problem) && (
          <p className={styles.problem} role="status">
            {overview?.problem || t("ui-fleet-no-answer")}
          </p>
        )}
        {overview && view === "stations" && <StationList stations={overview.stations} place={overview.place} />}
        {overview && view === "records" && <RecordSearch overview={overview} />}
        {overview && view === "drift" && <DriftView overview={overview} />}
        {overview && view === "calibrations" && (
          <>
            <SpreadTable overview={overview} />
            <CalibrationsTable names={new Map(overview.stations.map((one) => [one.id, one.name]))} />
          </>
        )}
        {overview && view === "ageing" && <AgeingView overview={overview} />}
      </main>
    </div>
  );
}
