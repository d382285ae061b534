import { Suspense, useEffect } from "react";

import styles from "./App.module.css";
import { CardHead } from "./controls/CardHead";
import { ArmQuestion } from "./frame/ArmQuestion";
import { Layout } from "./frame/Layout";
import { Rail } from "./frame/Rail";
import { StatusLine } from "./frame/StatusLine";
import { TopBar } from "./frame/TopBar";
import { HelpDialog } from "./guidance/HelpDialog";
import { EntrancePage } from "./pages/EntrancePage";
import { HomePage } from "./pages/HomePage";
import { LATER_PAGES } from "./pages/laterPages";
import { useDemonstration } from "./state/demonstration";
import { t, useLanguage } from "./state/language";
import { TITLES, usePage } from "./state/router";
import { useLive } from "./state/store";
import { useUnits } from "./state/units";
import { hasSession } from "./state/usePageSession";

const PAGES = { home: HomePage, ...LATER_PAGES };

export function App() {
  useDemonstration();
  const language = useLanguage();
  const units = useUnits();
  const chosen = usePage();
  const replays = useLive((s) => s.replay !== null);
  // nothing is to be done at a replay: its first page is the cloud
  const page = replays && chosen === "home" ? "scan" : chosen;
  const Page = PAGES[page];
  const session = useLive((s) => s.session);
  // whether a session is to be begun or is under way
  const waits = useLive((s) => !s.known) && hasSession(page);
  const title = `${t(TITLES[page])} · Crenel`;
  useEffect(() => {
    document.title = title;
  }, [title]);
  if (session && !session.you) return <EntrancePage session={session} />;
  // a kiosk screen has no controls: the page fills it
  if (session?.you?.kiosk) {
    return (
      <Suspense>
        <LATER_PAGES.supervise key={`${language} ${units}`} />
      </Suspense>
    );
  }
  return (
    <div className={styles.frame}>
      <button type="button" className={styles.skip} onClick={skipToMain}>
        {t("ui-skip-to-the-page")}
      </button>
      <TopBar page={page} />
      <Rail page={page} />
      {/* a page loads again in another language or unit, for it has loaded texts */}
      <Suspense key={page} fallback={<Waiting title={t(TITLES[page])} />}>
        {waits ? <Waiting title={t(TITLES[page])} /> : <Page key={`${language} ${units}`} />}
      </Suspense>
      <StatusLine />
      <ArmQuestion />
      <HelpDialog />
    </div>
  );
}

/** Past the bar and the pages. */
function skipToMain() {
  const main = document.querySelector("main");
  main?.setAttribute("tabindex", "-1");
  main?.focus();
}

function Waiting({ title }: { title: string }) {
  return <Layout picture={null} card={<CardHead title={title} text={t("ui-waiting-for-the-station")} />} />;
}
