import { figures } from "../parts/figures";
import { inUnit, lengthFigures, measured, signedLength, unitOf } from "../parts/lengths";
import { t } from "../state/language";
import styles from "./LengthErrors.module.css";

interface LengthError {
  place: number;
  repeat: number;
  length_mm: number;
  error_um: number;
  limit_um?: number | null;
}

interface LengthErrorsProps {
  errors: readonly LengthError[];
  /** The lengths of the standard with their permissible errors. */
  limits: readonly { length_mm: number; limit_um?: number | null }[];
  title?: string;
}

const WIDTH = 600;
const HEIGHT = 220;
const LEFT = 64;
const RIGHT = 24;
const TOP = 12;
const BOTTOM = 34;
const PLACES = 7;
/** Between the places of one length, so that equal errors are seen apart. */
const APART = 5;

/** The errors of length over the length, with the band of the permissible error. */
export function LengthErrors({ errors, limits, title = t("ui-errors-of-length") }: LengthErrorsProps) {
  const longest = Math.max(...limits.map(({ length_mm }) => length_mm), 1);
  const band = limits.filter((one): one is { length_mm: number; limit_um: number } => typeof one.limit_um === "number");
  const largest = errors.reduce((most, { error_um }) => Math.max(most, Math.abs(error_um)), 0);
  const top = 1.15 * Math.max(largest, ...band.map(({ limit_um }) => limit_um), 1);
  const x = (length: number) => LEFT + 30 + ((WIDTH - LEFT - RIGHT - 56) * length) / longest;
  const y = (error: number) => TOP + (HEIGHT - TOP - BOTTOM) * (0.5 - error / (2 * top));
  const edge = (sign: number) => band.map(({ length_mm, limit_um }) => `${x(length_mm)},${y(sign * limit_um)}`);
  return (
    <figure className={styles.errors}>
      <figcaption className={styles.title}>
        {title}
        <span className={styles.words}>
          {errors.length > 0
            ? t("ui-lengths-largest-error", { count: errors.length, value: measured(largest, "µm", 1) })
            : t("ui-no-length-yet")}
          {band.length > 0 && ` · ${t("ui-band-is-permissible-error")}`}
        </span>
      </figcaption>
      <svg className={styles.plot} viewBox={`0 0 ${WIDTH} ${HEIGHT}`} role="img" aria-label={title}>
        <rect className={styles.frame} x={LEFT} y={TOP} width={WIDTH - LEFT - RIGHT} height={HEIGHT - TOP - BOTTOM} />
        {band.length > 1 && <polygon className={styles.band} points={[...edge(1), ...edge(-1).reverse()].join(" ")} />}
        {band.length === 1 && band[0] && (
          <line
            className={styles.only}
            x1={x(band[0].length_mm)}
            x2={x(band[0].length_mm)}
            y1={y(band[0].limit_um)}
            y2={y(-band[0].limit_um)}
          />
        )}
        <line className={styles.zero} x1={LEFT} x2={WIDTH - RIGHT} y1={y(0)} y2={y(0)} />
        {[top / 1.15, 0, -top / 1.15].map((value) => (
          <text key={value} className={styles.scale} x={LEFT - 8} y={y(value)}>
            {lengthFigures(value, "µm", 0, value !== 0)}
          </text>
        ))}
        <text className={styles.unit} x={LEFT - 8} y={HEIGHT - 12}>
          {unitOf("µm")}
        </text>
        {limits.map(({ length_mm }) => (
          <text key={length_mm} className={styles.length} x={x(length_mm)} y={HEIGHT - 12}>
            {figures(inUnit(length_mm, "mm"), unitOf("mm") === "mm" ? 0 : 1)}
          </text>
        ))}
        <text className={styles.length} x={WIDTH - RIGHT + 8} y={HEIGHT - 12}>
          {unitOf("mm")}
        </text>
        {errors.map((one) => (
          <circle
            key={`${one.place}-${one.repeat}-${one.length_mm}`}
            className={styles.error}
            data-beyond={typeof one.limit_um === "number" && Math.abs(one.error_um) > one.limit_um}
            cx={x(one.length_mm) + APART * (one.place - (PLACES + 1) / 2)}
            cy={y(one.error_um)}
            r={3}
          >
            <title>
              {t("ui-length-error-of", {
                place: one.place,
                repeat: one.repeat,
                error: signedLength(one.error_um, "µm", 1),
              })}
            </title>
          </circle>
        ))}
      </svg>
    </figure>
  );
}
