import type { FigureLine } from "../../api/wire";
import { limitBeside } from "../../controls/limits";
import { QualityMark } from "../../controls/QualityMark";
import { partQuantity, uncertaintyQuantity } from "../../controls/uncertainty";
import { message } from "../../messages/text";
import { t } from "../../state/language";
import { SOURCES, statedUncertainties } from "./budget";
import styles from "./FigureBars.module.css";
import { DECISIONS, QUALITY, worded } from "./verification";

/** Each figure with its uncertainty and its limit. */
export function FigureBars({ found }: { found: FigureLine[] }) {
  return (
    <ul className={styles.list}>
      {found.map((figure) => (
        <Bar key={figure.name} figure={figure} />
      ))}
    </ul>
  );
}

/** An uncertainty, k = 2; `by` is empty of records that do not tell the two apart. */
interface Uncertainty {
  by: "test" | "measurement" | "";
  value: number;
}

/** The one that the limit is judged by, and the other. */
function uncertainties(figure: FigureLine): [Uncertainty, Uncertainty | null] {
  const { measurement, test } = statedUncertainties(figure);
  const by = figure.test_uncertainty === null ? "" : "measurement";
  const ofMeasurement: Uncertainty | null = measurement === null ? null : { by, value: measurement };
  const ofTest: Uncertainty | null = test === null ? null : { by: "test", value: test };
  const both = figure.judged_by === "test" ? [ofTest, ofMeasurement] : [ofMeasurement, ofTest];
  const [first, second] = both.filter((one) => one !== null);
  return [first ?? { by: "", value: 0 }, second ?? null];
}

function stated({ by, value }: Uncertainty, { unit, budget }: FigureLine): string {
  const whole = t("ui-u-value", { by, value: uncertaintyQuantity(value, unit) });
  const parts = SOURCES.flatMap(({ name: source }) => {
    const part = budget[source];
    return part === undefined ? [] : [message("ui-u-part", { source, value: partQuantity(2 * part, value, unit) })];
  });
  if (by !== "measurement" || parts.length === 0) return whole;
  return t("ui-u-from-parts", { whole, parts: { items: parts, separator: ", " } });
}

function Bar({ figure }: { figure: FigureLine }) {
  const { limit, unit } = figure;
  const [judging, other] = uncertainties(figure);
  const U = judging.value;
  const size = Math.abs(figure.value);
  const end = 1.08 * Math.max(limit ?? 0, size + U, 1e-6);
  const at = (value: number) => `${(100 * Math.min(Math.max(value, 0), end)) / end}%`;
  return (
    <li className={styles.figure} data-decision={figure.decision}>
      <div className={styles.head}>
        <span className={styles.title}>{figure.title}</span>
        <span className={styles.value}>{worded(figure)}</span>
      </div>
      <div className={styles.track} aria-hidden="true">
        <span className={styles.bar} style={{ width: at(size) }} />
        {U > 0 && (
          <span
            className={styles.unsure}
            style={{ left: at(size - U), width: `calc(${at(size + U)} - ${at(size - U)})` }}
          />
        )}
        {limit !== null && <span className={styles.limit} style={{ left: at(limit) }} />}
      </div>
      <p className={styles.words}>
        {limit === null ? (
          <span>{t("ui-for-information-without-a-limit")}</span>
        ) : (
          <>
            <QualityMark quality={QUALITY[figure.decision]} size="1.125rem" />
            <strong>{t(DECISIONS[figure.decision])}</strong>
            <span>{t("ui-limit-value", { value: limitBeside(limit, unit, 1, figure.value) })}</span>
          </>
        )}
        {U > 0 && <span>{stated(judging, figure)}</span>}
        {other && <span>{stated(other, figure)}</span>}
      </p>
    </li>
  );
}
