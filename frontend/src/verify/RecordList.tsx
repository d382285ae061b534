import type { VerificationSummary } from "../api/verifyTypes";
import { moment } from "../parts/format";
import { QualityMark } from "../parts/QualityMark";
import { said, t } from "../state/language";
import { setState } from "../state/store";
import styles from "./RecordList.module.css";
import { QUALITY } from "./shown";

/** Verifications of before; one of them is shown. */
export function RecordList({ list, shown }: { list: VerificationSummary[]; shown: string }) {
  return (
    <section className={styles.records}>
      <h2 className={styles.title}>{t("Before")}</h2>
      <ul className={styles.list}>
        {list.map((one) => (
          <li key={one.id}>
            <button type="button" className={styles.row} aria-pressed={one.id === shown} onClick={() => setState({ record: one.id })}>
              <QualityMark quality={QUALITY[one.result]} size="1.25rem" />
              <span>
                {moment(one.accepted_at)}
                <span className={styles.detail}>{said(one.gauge)}</span>
              </span>
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}
