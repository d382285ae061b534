import type { ReactNode } from "react";

import type { ArmCheckSummary, IdentificationSummary, TipCheckSummary } from "../api/wire";
import { EmptyState } from "../controls/EmptyState";
import rows from "../controls/List.module.css";
import { GaugeDrawing } from "../gauges/plan/GaugeDrawing";
import { t } from "../state/language";
import { ArmRow, IdentifiedRow, TipRow } from "./CheckRows";
import styles from "./History.module.css";
import { HistoryChart } from "./HistoryChart";
import { SeatIllustration } from "./SeatIllustration";
import { useArmList } from "./useArmList";

export type Past = "arm" | "tip" | "identified";

/** What was done before: checks of the arm as a line over time and one by one, all else one by one. */
export function History({ of }: { of: Past }) {
  if (of === "tip") {
    return (
      <PastList<TipCheckSummary>
        key={of}
        name="tips"
        title={t("ui-tip-checks")}
        empty={
          <EmptyState
            picture={<GaugeDrawing shape="sphere" touching />}
            title={t("ui-no-tip-check-yet")}
            text={t("ui-touch-sphere-known-diameter-nine-places")}
          />
        }
        row={(check) => <TipRow key={check.id} check={check} />}
      />
    );
  }
  if (of === "identified") {
    return (
      <PastList<IdentificationSummary>
        key={of}
        name="identifications"
        title={t("ui-arm-identifications")}
        empty={
          <EmptyState
            picture={<SeatIllustration />}
            title={t("ui-not-yet-identified-here")}
            text={t("ui-identification-appears-arms-deviation-datasheet-uncertainty")}
          />
        }
        row={(found) => <IdentifiedRow key={found.id} found={found} />}
      />
    );
  }
  return (
    <PastList<ArmCheckSummary>
      key={of}
      name="checks"
      title={t("ui-arm-checks-max-min-2-worst")}
      empty={
        <EmptyState
          picture={<SeatIllustration />}
          title={t("ui-no-check-yet")}
          text={t("ui-every-arm-check-appears-over-time")}
        />
      }
      above={(checks) => <HistoryChart checks={checks} />}
      row={(check) => <ArmRow key={check.id} check={check} />}
    />
  );
}

interface PastListProps<T> {
  name: Parameters<typeof useArmList>[0];
  title: string;
  empty: ReactNode;
  above?: (list: T[]) => ReactNode;
  row: (item: T) => ReactNode;
}

function PastList<T>({ name, title, empty, above, row }: PastListProps<T>) {
  const { list, failed } = useArmList<T>(name);
  if (!list) return failed ? <p className={styles.note}>{t("ui-checks-could-not-loaded-they-reload")}</p> : null;
  if (list.length === 0) return empty;
  return (
    <div className={styles.history}>
      <h2 className={styles.title}>{title}</h2>
      {above?.(list)}
      <ul className={rows.list}>{list.map(row)}</ul>
    </div>
  );
}
