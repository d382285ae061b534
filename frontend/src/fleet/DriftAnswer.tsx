import type { DriftDoubtedRecordings, DriftHistory, DriftPeriod, FleetRecord } from "../api/wire";
import { figures, moment } from "../controls/format";
import { measured } from "../controls/lengths";
import { QualityMark } from "../controls/QualityMark";
import { t } from "../state/language";
import { decimalsOf } from "./answers";
import styles from "./FleetPage.module.css";

/** What the values of a station are too few, or not sure enough, for. */
export function DriftNotes({
  history,
  least,
  unit,
  doubted,
}: {
  history: DriftHistory;
  least: number;
  unit: string;
  doubted: DriftDoubtedRecordings[];
}) {
  const { levels, standing_out, spread } = history;
  const value = (one: number) => measured(one, unit, decimalsOf(unit));
  return (
    <>
      {levels.length > 1 && spread.calibrations > 1 && (
        <p className={styles.note}>
          {spread.standard_deviation === null
            ? t("ui-fleet-own-errors-unknown", { n: spread.calibrations })
            : t("ui-fleet-own-errors", { n: spread.calibrations, deviation: value(spread.standard_deviation) })}
        </p>
      )}
      {spread.doubtful.map(({ calibration_id, size, since, until }) => {
        const recordings = doubted.find((one) => one.calibration_id === calibration_id)?.recordings ?? [];
        return (
          <div key={calibration_id}>
            <p>
              <QualityMark quality="attention" size="1.1em" />{" "}
              {t("ui-fleet-doubtful", {
                calibration: calibration_id,
                size: `${signed(size)} ${unit}`,
                since: moment(since),
                until: moment(until),
              })}
            </p>
            <RecordingList
              summary={t("ui-fleet-would-be-affected", { n: recordings.length })}
              recordings={recordings}
            />
          </div>
        );
      })}
      {standing_out.length > 0 && (
        <div>
          <p>{t("ui-fleet-standing-out", { n: standing_out.length, least })}</p>
          <ul className={styles.recordings}>
            {standing_out.map((one) => (
              <li key={one.at}>{[moment(one.at), value(one.value), one.calibration_id].filter(Boolean).join(" · ")}</li>
            ))}
          </ul>
        </div>
      )}
    </>
  );
}

/** A stretch of time in which the figure differed from the right level, and its recordings. */
export function AffectedPeriod({ period, unit }: { period: DriftPeriod; unit: string }) {
  const { ended, levels, calibration_ids, recordings, possible } = period;
  return (
    <div className={styles.affected}>
      <p>
        <QualityMark quality="attention" size="1.1em" /> {beginning(period, unit)}{" "}
        {levels
          .slice(1)
          .map((one) =>
            t("ui-fleet-then", { value: measured(one.value, unit, decimalsOf(unit)), since: moment(one.since) }),
          )
          .join(" ")}{" "}
        {ended ? t("ui-fleet-ended", { when: moment(ended.by) }) : t("ui-fleet-lasts")}
      </p>
      {calibration_ids.length > 0 && <p>{t("ui-fleet-explained", { calibrations: calibration_ids.join(", ") })}</p>}
      <RecordingList
        summary={[
          t("ui-fleet-affected", { n: recordings.length }),
          ...(possible.length > 0 ? [t("ui-fleet-possible", { n: possible.length })] : []),
        ].join(" ")}
        recordings={[...recordings, ...possible]}
      />
    </div>
  );
}

function RecordingList({ summary, recordings }: { summary: string; recordings: FleetRecord[] }) {
  return (
    <details>
      <summary>{summary}</summary>
      <ul className={styles.recordings}>
        {recordings.map((one) => (
          <li key={one.id}>{`${moment(one.at)} · ${one.label || one.id}`}</li>
        ))}
      </ul>
    </details>
  );
}

function beginning({ change, levels, right_value, standard_uncertainty }: DriftPeriod, unit: string): string {
  const size = (levels[0]?.value ?? right_value) - right_value;
  const by = {
    size: signed(size),
    uncertainty: figures(2 * standard_uncertainty, 1),
    unit,
  };
  if (!change) return t("ui-fleet-differed", { ...by, since: moment(levels[0]?.since ?? "") });
  return t("ui-fleet-changed", { ...by, earliest: moment(change.earliest), latest: moment(change.latest) });
}

function signed(size: number): string {
  return `${size > 0 ? "+" : ""}${figures(size, 1)}`;
}
