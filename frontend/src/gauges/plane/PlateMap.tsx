import { t } from "../../state/language";
import styles from "./PlateMap.module.css";

const SIDE = 140;
/** Where the strips of a scan lie, across the way of the stripe. */
const STRIPS = [-24, 24];
const HALF_STRIPE = 30;
const HALF_WAY = 58;

/** The plate from above: how the stripe lies in an orientation, and the strips that it is led over. */
export function PlateMap({ orientation }: { orientation: number }) {
  const turn = orientation === 2 ? 45 : -45;
  return (
    <svg className={styles.map} viewBox="-110 -110 220 220" role="img" aria-label={t("ui-plate-from-above")}>
      <title>{t("ui-plate-from-above")}</title>
      <rect className={styles.plate} x={-SIDE / 2} y={-SIDE / 2} width={SIDE} height={SIDE} rx="2" />
      <g transform={`rotate(${turn})`}>
        {STRIPS.map((x, i) => (
          <g key={x} transform={`translate(${x} 0)${i % 2 ? " rotate(180)" : ""}`}>
            <rect
              className={styles.strip}
              x={-HALF_STRIPE}
              y={-HALF_WAY}
              width={2 * HALF_STRIPE}
              height={2 * HALF_WAY}
            />
            <line className={styles.stripe} x1={-HALF_STRIPE} x2={HALF_STRIPE} y1={HALF_WAY - 22} y2={HALF_WAY - 22} />
            <path className={styles.way} d={`M0 ${HALF_WAY - 30} V ${-HALF_WAY + 8} m -6 9 l 6 -9 l 6 9`} />
          </g>
        ))}
      </g>
    </svg>
  );
}
