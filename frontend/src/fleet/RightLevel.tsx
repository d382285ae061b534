import type { DriftHistory } from "../api/wire";
import { moment } from "../controls/format";
import { measured } from "../controls/lengths";
import { t } from "../state/language";
import { decimalsOf } from "./answers";
import styles from "./FleetPage.module.css";

/** Which level is taken as right, and why; the choice of another one. */
export function RightLevel({
  history,
  unit,
  since,
  onChange,
}: {
  history: DriftHistory;
  unit: string;
  since: string;
  onChange: (since: string) => void;
}) {
  const { levels, right } = history;
  const value = (level: number) => measured(level, unit, decimalsOf(unit));
  if (!right) return null;
  return (
    <div className={styles.form}>
      <label>
        {t("ui-fleet-right-level")}
        <select value={since} onChange={(event) => onChange(event.target.value)}>
          <option value="">{t("ui-fleet-right-proposed")}</option>
          {levels.map((one) => (
            <option key={one.since} value={one.since}>
              {t("ui-fleet-level", { value: value(one.value), since: moment(one.since), n: one.values })}
            </option>
          ))}
        </select>
      </label>
      <p className={styles.right}>
        {t("ui-fleet-right", {
          value: value(right.value),
          since: moment(right.since),
          n: right.values,
          total: levels.reduce((sum, one) => sum + one.values, 0),
          because: right.because,
        })}
      </p>
    </div>
  );
}
