import type { ArmCheckSummary, IdentificationSummary, TipCheckSummary } from "../api/wire";
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
        title={t("ui-not-yet-identified-here")}
        text={t("ui-identification-appears-arms-deviation-datasheet-uncertainty")}
      />
    );
  }
  return (
    <div className={styles.history}>
      <h2 className={styles.title}>{t("ui-arm-identifications")}</h2>
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
        title={t("ui-no-tip-check-yet")}
        text={t("ui-touch-sphere-known-diameter-nine-places")}
      />
    );
  }
  return (
    <div className={styles.history}>
      <h2 className={styles.title}>{t("ui-tip-checks")}</h2>
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
  if (!list) return failed ? <p className={styles.note}>{t("ui-checks-could-not-loaded-they-reload")}</p> : null;
  if (list.length === 0) {
    return (
      <EmptyState
        picture={<SeatIllustration />}
        title={t("ui-no-check-yet")}
        text={t("ui-every-arm-check-appears-over-time")}
      />
    );
  }
  return (
    <div className={styles.history}>
      <h2 className={styles.title}>{t("ui-arm-checks-max-min-2-worst")}</h2>
      <HistoryChart checks={list} />
      <ul className={rows.list}>
        {list.map((check) => (
          <ArmRow key={check.id} check={check} />
        ))}
      </ul>
    </div>
  );
}
