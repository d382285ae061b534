import type { InspectionSummary } from "../api/wire";
import { moment } from "../controls/format";
import rows from "../controls/List.module.css";
import { PressButton } from "../controls/PressButton";
import { QualityMark } from "../controls/QualityMark";
import styles from "../records/Rows.module.css";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import { go } from "../state/router";
import { OUTCOME_QUALITY } from "./outcomes";

/** A finished inspection in a list, with its verdict. */
export function InspectionRow({ summary }: { summary: InspectionSummary }) {
  const { id, part, program, serial_number, ended_at, text, operator, result } = summary;
  const name = [part || program, serial_number].filter(Boolean).join(" · ");
  return (
    <li className={`${rows.row} ${styles.row}`}>
      <QualityMark quality={OUTCOME_QUALITY[result]} />
      <div className={styles.what}>
        <p className={rows.name}>{isolated(name)}</p>
        <p className={rows.detail}>
          {moment(ended_at)} · {text}
          {operator && ` · ${isolated(operator)}`}
        </p>
        <p className={rows.detail}>
          {t("ui-part-counts", { passed: summary.passed, failed: summary.failed, undecided: summary.undecided })}
        </p>
      </div>
      <PressButton free onPress={() => go("part", id)}>
        {t("ui-open")}
      </PressButton>
    </li>
  );
}
