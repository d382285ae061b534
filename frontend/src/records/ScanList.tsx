import { useCallback, useState } from "react";

import { compareRecord, mergeScans } from "../api/recordCommands";
import type { ScanSummary } from "../api/wire";
import rows from "../controls/List.module.css";
import { PressButton } from "../controls/PressButton";
import { t } from "../state/language";
import { go } from "../state/router";
import { useLive } from "../state/store";
import { useList } from "../state/useList";
import styles from "./ScanList.module.css";
import { ScanRow, textsOf } from "./ScanRow";
import { matches } from "./search";

/** So many are displayed at first, and more on request. */
const FIRST = 50;

/** All scans that a search finds, the newest first; some can be chosen, to merge or compare them. */
export function ScanList({ search }: { search: string }) {
  const records = useLive((s) => s.view?.records ?? 0);
  const { list, failed } = useList<ScanSummary>("/api/scans", `${records}`);
  const [shown, setShown] = useState(FIRST);
  const [chosen, setChosen] = useState<readonly string[]>([]);
  const choose = useCallback(
    (id: string, on: boolean) => setChosen((before) => (on ? [...before, id] : before.filter((one) => one !== id))),
    [],
  );
  const found = list?.filter((scan) => matches(search, textsOf(scan))) ?? [];
  const there = chosen.filter((id) => list?.some((scan) => scan.id === id));
  return (
    <section aria-label={t("ui-scans")}>
      <div className={styles.head}>
        <h2 className={rows.heading}>{t("ui-scans")}</h2>
        {list && list.length > 0 && <p>{t("ui-n-of-all-scans", { n: found.length, all: list.length })}</p>}
      </div>
      {there.length > 0 && <Chosen ids={there} onEnd={() => setChosen([])} />}
      {found.length > 0 ? (
        <ul className={rows.list}>
          {found.slice(0, shown).map((scan) => (
            <ScanRow key={scan.id} scan={scan} chosen={chosen.includes(scan.id)} onChoose={choose} />
          ))}
        </ul>
      ) : (
        <p className={rows.empty}>{emptyWords(list, failed)}</p>
      )}
      {found.length > shown && (
        <div className={styles.more}>
          <PressButton free onPress={() => setShown(shown + 4 * FIRST)}>
            {t("ui-show-more-of", { n: found.length - shown })}
          </PressButton>
        </div>
      )}
    </section>
  );
}

function emptyWords(list: ScanSummary[] | null, failed: boolean): string {
  if (!list) return failed ? t("ui-list-could-not-loaded-reloads-when") : t("ui-loading-the-list");
  return list.length ? t("ui-no-scan-is-like-that") : t("ui-saved-clouds-appear-newest-first-start");
}

/** What can be done with several scans: the first one is what the others are compared with, or begins the cloud. */
function Chosen({ ids, onEnd }: { ids: string[]; onEnd: () => void }) {
  const [reference, other] = ids;
  const merge = async () => {
    if (await mergeScans(ids)) onEnd();
  };
  const compare = async () => {
    if (reference && other && (await compareRecord(other, reference))) go("records", `scan/${other}`);
  };
  return (
    <div className={styles.chosen}>
      <p>{ids.length < 2 ? t("ui-choose-another-scan") : t("ui-n-scans-chosen", { n: ids.length })}</p>
      {ids.length > 1 && <PressButton onPress={merge}>{t("ui-merge-into-one-cloud")}</PressButton>}
      {ids.length === 2 && <PressButton onPress={compare}>{t("ui-compare")}</PressButton>}
      <PressButton kind="quiet" free onPress={onEnd}>
        {t("ui-choose-none")}
      </PressButton>
    </div>
  );
}
