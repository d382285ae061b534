import type { ArmCheckSummary, IdentificationSummary, TipCheckSummary } from "../api/armTypes";
import { EmptyState } from "../parts/EmptyState";
import rows from "../parts/List.module.css";
import { t } from "../state/language";
import { useLive } from "../state/store";
import { useList } from "../state/useList";
import { GaugeDrawing } from "../verify/GaugeDrawing";
import { ArmRow, IdentifiedRow, TipRow } from "./CheckRows";
import styles from "./History.module.css";
import { HistoryChart } from "./HistoryChart";
import { SeatIllustration } from "./SeatIllustration";

export type Past = "arm" | "tip" | "identified";

/** What was done before: checks of the arm as a line over time and one by one, all else one by one. */
export function History({ of }: { of: Past }) {
  if (of === "tip") return <TipHistory />;
  return of === "identified" ? <IdentifiedHistory /> : <ArmHistory />;
}

function IdentifiedHistory() {
  const grown = useLive((s) => `${s.arm?.session_id ?? ""} ${s.arm?.step ?? ""}`);
  const { list } = useList<IdentificationSummary>("/api/arm/identifications", grown);
  if (!list) return null;
  if (list.length === 0) {
    return (
      <EmptyState
        picture={<SeatIllustration />}
        title={t("Not identified here yet")}
        text={t("Each identification will stand here: by how much the arm differed from its papers, how well it is known since, and its report.")}
      />
    );
  }
  return (
    <div className={styles.history}>
      <h2 className={styles.title}>{t("Identifications of the arm")}</h2>
      <ul className={rows.list}>
        {list.map((found) => (
          <IdentifiedRow key={found.id} found={found} />
        ))}
      </ul>
    </div>
  );
}

function TipHistory() {
  const grown = useLive((s) => `${s.arm?.session_id ?? ""} ${s.arm?.step ?? ""}`);
  const { list } = useList<TipCheckSummary>("/api/arm/tips", grown);
  if (!list) return null;
  if (list.length === 0) {
    return (
      <EmptyState
        picture={<GaugeDrawing shape="sphere" touching />}
        title={t("No check of the tip yet")}
        text={t("A sphere of known diameter, touched in nine places with the wrist turned, tells a worn, bent or wrong tip before it spoils a day's work.")}
      />
    );
  }
  return (
    <div className={styles.history}>
      <h2 className={styles.title}>{t("Checks of the tip")}</h2>
      <ul className={rows.list}>
        {list.map((check) => (
          <TipRow key={check.id} check={check} />
        ))}
      </ul>
    </div>
  );
}

function ArmHistory() {
  const grown = useLive((s) => `${s.arm?.session_id ?? ""} ${s.arm?.step ?? ""}`);
  const { list, failed } = useList<ArmCheckSummary>("/api/arm/checks", grown);
  if (!list) return failed ? <p className={styles.told}>{t("The checks could not be read. They are read again when the station is back.")}</p> : null;
  if (list.length === 0) {
    return (
      <EmptyState
        picture={<SeatIllustration />}
        title={t("No check yet")}
        text={t("Every check of the arm will stand here, as a line over time: (max − min)/2 of the tip on the worst axis, against your limit.")}
      />
    );
  }
  return (
    <div className={styles.history}>
      <h2 className={styles.title}>{t("Checks of the arm: (max − min)/2 on the worst axis")}</h2>
      <HistoryChart checks={list} />
      <ul className={rows.list}>
        {list.map((check) => (
          <ArmRow key={check.id} check={check} />
        ))}
      </ul>
    </div>
  );
}
