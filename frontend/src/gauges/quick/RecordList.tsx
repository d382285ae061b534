import type { VerificationSummary } from "../../api/wire";
import { moment } from "../../controls/format";
import { QualityMark } from "../../controls/QualityMark";
import { isolated } from "../../state/isolated";
import { t } from "../../state/language";
import { setState } from "../../state/store";
import styles from "./RecordList.module.css";
import { QUALITY } from "./verification";

/** Earlier verifications; one of them is open. */
export function RecordList({ list, selected }: { list: VerificationSummary[]; selected: string }) {
  return (
    <section className={styles.records}>
      <h2 className={styles.title}>{t("ui-before")}</h2>
      <ul className={styles.list}>
        {list.map((one) => (
          <li key={one.id}>
            <button
              type="button"
              className={styles.row}
              aria-pressed={one.id === selected}
              onClick={() => setState({ record: one.id })}
            >
              <QualityMark quality={QUALITY[one.result]} size="1.25rem" />
              <span>
                {moment(one.accepted_at)}
                <span className={styles.detail}>{isolated(one.gauge)}</span>
              </span>
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}
