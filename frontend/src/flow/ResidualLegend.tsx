import { DEVIATION_CSS } from "../controls/deviationColours";
import { lengthFigures, measured } from "../controls/lengths";
import { t } from "../state/language";
import styles from "./ResidualLegend.module.css";

/** Legend of the dot colours. */
export function ResidualLegend({ scale_um, sticks = false }: { scale_um: number; sticks?: boolean }) {
  return (
    <div className={styles.legend}>
      <span>−{lengthFigures(scale_um, "µm")}</span>
      <span className={styles.ramp} style={{ background: DEVIATION_CSS }} />
      <span>
        +{measured(scale_um, "µm")} {t("ui-residual-lowercase")}
      </span>
      <svg width="18" height="18" viewBox="-9 -9 18 18" aria-hidden="true">
        <path d="M0-8 8 0 0 8-8 0Z" className={styles.diamond} />
      </svg>
      <span>{t("ui-outlier")}</span>
      {sticks && <span className={styles.sticks}>{t("ui-lines-point-outward-or-inward")}</span>}
    </div>
  );
}
