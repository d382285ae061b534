import { useState } from "react";
import type { FleetOverview, FoundFleetRecord, RecordsPage } from "../api/wire";
import { figures, moment } from "../controls/format";
import { QualityMark } from "../controls/QualityMark";
import { useSettled } from "../controls/useSettled";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import { KINDS, qualityOf, useAnswer } from "./answers";
import styles from "./FleetPage.module.css";
import { RecordDetail } from "./RecordDetail";

interface Query {
  text: string;
  station: string;
  kind: string;
  since: string;
  until: string;
}

const EVERYTHING: Query = { text: "", station: "", kind: "", since: "", until: "" };
const DAY_MS = 86_400_000;
const LAST_DAY = "2999-12-31";

function addressOf({ text, station, kind, since, until }: Query, before: FoundFleetRecord | null): string {
  const wanted = new URLSearchParams({ text, station, kind });
  if (since) wanted.set("since", new Date(`${since}T00:00`).toISOString());
  // the last day is included
  if (until) wanted.set("until", new Date(new Date(`${until}T00:00`).getTime() + DAY_MS).toISOString());
  if (before) {
    wanted.set("before", before.at);
    wanted.set("before_key", String(before.key));
  }
  return `/api/fleet/records?${wanted}`;
}

/** The records of all stations, found by words, period, station and kind. */
export function RecordSearch({ overview }: { overview: FleetOverview }) {
  const [query, setQuery] = useState(EVERYTHING);
  const [pages, setPages] = useState<(FoundFleetRecord | null)[]>([null]);
  const [chosen, choose] = useState<FoundFleetRecord | null>(null);
  const text = useSettled(query.text);
  const names = new Map(overview.stations.map((one) => [one.id, one.name]));
  const isReversed = query.since !== "" && query.until !== "" && query.since > query.until;
  const change = (part: Partial<Query>) => {
    setQuery({ ...query, ...part });
    setPages([null]);
  };
  if (chosen) return <RecordDetail found={chosen} station={names.get(chosen.station)} onBack={() => choose(null)} />;
  return (
    <section aria-label={t("ui-fleet-records")}>
      <form className={styles.form} role="search" onSubmit={(event) => event.preventDefault()}>
        <label>
          {t("ui-fleet-words")}
          <input type="search" value={query.text} onChange={(event) => change({ text: event.target.value })} />
        </label>
        <label>
          {t("ui-station")}
          <select value={query.station} onChange={(event) => change({ station: event.target.value })}>
            <option value="">{t("ui-all")}</option>
            {overview.stations.map(({ id, name }) => (
              <option key={id} value={id}>
                {name}
              </option>
            ))}
          </select>
        </label>
        <label>
          {t("ui-fleet-kind")}
          <select value={query.kind} onChange={(event) => change({ kind: event.target.value })}>
            <option value="">{t("ui-all")}</option>
            {overview.kinds.map((kind) => (
              <option key={kind} value={kind}>
                {kindName(kind)}
              </option>
            ))}
          </select>
        </label>
        <DayField
          label={t("ui-fleet-since")}
          value={query.since}
          invalid={isReversed}
          onChange={(since) => change({ since })}
        />
        <DayField
          label={t("ui-fleet-until")}
          value={query.until}
          invalid={isReversed}
          onChange={(until) => change({ until })}
        />
        {isReversed && (
          <p className={styles.trouble} role="alert">
            {t("ui-fleet-days-reversed")}
          </p>
        )}
      </form>
      {!isReversed && (
        <div className={`${styles.scroll} ${styles.found}`}>
          <table className={styles.table}>
            <thead>
              <tr>
                <th scope="col">{t("ui-time")}</th>
                <th scope="col">{t("ui-station")}</th>
                <th scope="col">{t("ui-fleet-kind")}</th>
                <th scope="col">{t("ui-fleet-label")}</th>
                <th scope="col">{t("ui-fleet-verdict")}</th>
                <th scope="col">{t("ui-calibration")}</th>
                <th scope="col">{t("ui-fleet-archived")}</th>
              </tr>
            </thead>
            {pages.map((before, number) => (
              <Page
                key={before?.key ?? 0}
                path={addressOf({ ...query, text }, before)}
                typing={text !== query.text}
                last={number === pages.length - 1}
                names={names}
                onChoose={choose}
                onMore={(end) => setPages([...pages, end])}
              />
            ))}
          </table>
        </div>
      )}
    </section>
  );
}

/** A day of the calendar, empty for none. */
function DayField({
  label,
  value,
  invalid,
  onChange,
}: {
  label: string;
  value: string;
  invalid: boolean;
  onChange: (day: string) => void;
}) {
  return (
    <label>
      {label}
      <input
        type="date"
        max={LAST_DAY}
        value={value}
        aria-invalid={invalid}
        onChange={(event) => onChange(event.target.value)}
      />
    </label>
  );
}

/** Records of one answer; those of the search before stay, dimmed, until the answer is there. */
function Page({
  path,
  typing,
  last,
  names,
  onChoose,
  onMore,
}: {
  path: string;
  typing: boolean;
  last: boolean;
  names: Map<string, string>;
  onChoose: (found: FoundFleetRecord) => void;
  onMore: (end: FoundFleetRecord) => void;
}) {
  const { value, waiting } = useAnswer<RecordsPage>(path);
  const searching = typing || waiting;
  const { records, more } = value ?? { records: [], more: false };
  const end = records[records.length - 1];
  return (
    <tbody aria-busy={searching}>
      {searching && (
        <tr className={styles.searching}>
          <td colSpan={7}>
            <span role="status">{t("ui-searching")}</span>
          </td>
        </tr>
      )}
      {records.map((found) => (
        <tr key={found.key}>
          <td>
            <button type="button" className={styles.link} onClick={() => onChoose(found)}>
              {moment(found.at)}
            </button>
          </td>
          <td className={styles.wraps}>{isolated(names.get(found.station) ?? found.station)}</td>
          <td>{kindName(found.kind)}</td>
          <td className={styles.wraps}>{found.label || found.id}</td>
          <td>
            {found.verdict && <QualityMark quality={qualityOf(found.verdict)} size="1.1em" />}
            {found.points !== null && !found.verdict && t("ui-n-points", { n: found.points })}
          </td>
          <td className={styles.wraps}>{found.calibration_id}</td>
          <td className={styles.archived}>{found.archived_at ? moment(found.archived_at) : "–"}</td>
        </tr>
      ))}
      {last && value && !searching && records.length === 0 && (
        <tr>
          <td colSpan={7} className={styles.note}>
            {t("ui-fleet-nothing-found")}
          </td>
        </tr>
      )}
      {last && more && end && (
        <tr>
          <td colSpan={7}>
            <button type="button" className={styles.more} onClick={() => onMore(end)}>
              {t("ui-display-more", { n: figures(50) })}
            </button>
          </td>
        </tr>
      )}
    </tbody>
  );
}

/** The name of a kind of record. */
export function kindName(kind: string): string {
  const id = KINDS[kind];
  return id ? t(id) : kind;
}
