import { figures } from "../../controls/figures";
import { inUnit, lengthFigures, measured, signedLength, unitOf } from "../../controls/lengths";
import { t } from "../../state/language";
import styles from "./LengthErrors.module.css";

interface LengthError {
  place: number;
  repeat: number;
  length_mm: number;
  error_um: number;
  limit_um?: number | null;
}

interface Limit {
  length_mm: number;
  limit_um?: number | null;
}

/** Errors of length with the lengths of the standard and their permissible errors. */
interface Errors {
  errors: readonly LengthError[];
  limits: readonly Limit[];
}

interface LengthErrorsProps {
  touched?: Errors | null;
  scanned?: Errors | null;
}

const WIDTH = 600;
const HEIGHT = 220;
const LEFT = 64;
const RIGHT = 24;
const TOP = 12;
const BOTTOM = 34;
const PLACES = 7;
/** Between the places of one length, so that equal errors are seen apart; and if those by scan are drawn beside those by
 * touch, with both to their side of the length. */
const APART = 5;
const APART_BESIDE = 3.5;
const ASIDE = 12;
/** Half the width of a limit of a single length. */
const ONLY = 24;
const NONE: Errors = { errors: [], limits: [] };

/** The errors of length over the length, by touch as dots and by scan as rings: the band is the
 * permissible error by touch, or the only one; dashed lines are that by scan beside it. */
export function LengthErrors({ touched, scanned }: LengthErrorsProps) {
  const both = Boolean(touched && scanned);
  const main = touched ?? scanned ?? NONE;
  const beside = both && scanned ? scanned : NONE;
  const all = [...main.errors, ...beside.errors];
  const band = known(main.limits);
  const dashed = known(beside.limits);
  const longest = Math.max(...main.limits.map(({ length_mm }) => length_mm), 1);
  const top = 1.15 * Math.max(largest(all), ...[...band, ...dashed].map(({ limit_um }) => limit_um), 1);
  const x = (length: number) => LEFT + 30 + ((WIDTH - LEFT - RIGHT - 56) * length) / longest;
  const y = (error: number) => TOP + (HEIGHT - TOP - BOTTOM) * (0.5 - error / (2 * top));
  const apart = both ? APART_BESIDE : APART;
  const aside = both ? ([-ASIDE, ASIDE] as const) : ([0, 0] as const);
  const edge = (sign: number, limits: KnownLimit[]) =>
    limits.length === 1 && limits[0]
      ? [-ONLY, ONLY].map((off) => `${x(limits[0]?.length_mm ?? 0) + off},${y(sign * (limits[0]?.limit_um ?? 0))}`)
      : limits.map(({ length_mm, limit_um }) => `${x(length_mm)},${y(sign * limit_um)}`);
  const title = t(touched ? "ui-errors-of-length" : "ui-errors-of-length-by-scan");
  return (
    <figure className={styles.errors}>
      <figcaption className={styles.title}>
        {title}
        {both ? (
          <Key touched={main} scanned={beside} />
        ) : (
          <span className={styles.words}>
            {counted(main.errors)}
            {band.length > 0 && ` · ${t("ui-band-is-permissible-error")}`}
          </span>
        )}
      </figcaption>
      <svg className={styles.plot} viewBox={`0 0 ${WIDTH} ${HEIGHT}`} role="img" aria-label={title}>
        <rect className={styles.frame} x={LEFT} y={TOP} width={WIDTH - LEFT - RIGHT} height={HEIGHT - TOP - BOTTOM} />
        {band.length > 0 && (
          <polygon className={styles.band} points={[...edge(1, band), ...edge(-1, band).reverse()].join(" ")} />
        )}
        {dashed.length > 0 &&
          [1, -1].map((sign) => (
            <polyline key={sign} className={styles.dashed} points={edge(sign, dashed).join(" ")} />
          ))}
        <line className={styles.zero} x1={LEFT} x2={WIDTH - RIGHT} y1={y(0)} y2={y(0)} />
        {[top / 1.15, 0, -top / 1.15].map((value) => (
          <text key={value} className={styles.scale} x={LEFT - 8} y={y(value)}>
            {lengthFigures(value, "µm", 0, value !== 0)}
          </text>
        ))}
        <text className={styles.unit} x={LEFT - 8} y={HEIGHT - 12}>
          {unitOf("µm")}
        </text>
        {main.limits.map(({ length_mm }) => (
          <text key={length_mm} className={styles.length} x={x(length_mm)} y={HEIGHT - 12}>
            {figures(inUnit(length_mm, "mm"), unitOf("mm") === "mm" ? 0 : 1)}
          </text>
        ))}
        <text className={styles.length} x={WIDTH - RIGHT + 8} y={HEIGHT - 12}>
          {unitOf("mm")}
        </text>
        {([0, 1] as const).map((k) =>
          (k === 0 ? main : beside).errors.map((one) => (
            <circle
              key={`${k} ${one.place}-${one.repeat}-${one.length_mm}`}
              className={styles.error}
              data-by={k === 0 && touched ? "touch" : "scan"}
              data-beyond={typeof one.limit_um === "number" && Math.abs(one.error_um) > one.limit_um}
              cx={x(one.length_mm) + aside[k] + apart * (one.place - (PLACES + 1) / 2)}
              cy={y(one.error_um)}
              r={3}
            >
              <title>
                {t(k === 0 && touched ? "ui-length-error-of" : "ui-length-error-by-scan-of", {
                  place: one.place,
                  repeat: one.repeat,
                  error: signedLength(one.error_um, "µm", 1),
                })}
              </title>
            </circle>
          )),
        )}
      </svg>
    </figure>
  );
}

/** What is drawn how, with how many lengths and their largest error. */
function Key({ touched, scanned }: { touched: Errors; scanned: Errors }) {
  return (
    <span className={styles.key}>
      <span className={styles.words}>
        <Dot by="touch" /> {t("ui-by-touch")}: {counted(touched.errors)}
        {known(touched.limits).length > 0 && ` · ${t("ui-band-is-permissible-error")}`}
      </span>
      <span className={styles.words}>
        <Dot by="scan" /> {t("ui-by-scan")}: {counted(scanned.errors)}
        {known(scanned.limits).length > 0 && ` · ${t("ui-dashed-is-permissible-error")}`}
      </span>
    </span>
  );
}

function Dot({ by }: { by: "touch" | "scan" }) {
  return (
    <svg className={styles.dot} viewBox="0 0 10 10" aria-hidden="true">
      <circle className={styles.error} data-by={by} cx={5} cy={5} r={3} />
    </svg>
  );
}

type KnownLimit = { length_mm: number; limit_um: number };

function known(limits: readonly Limit[]): KnownLimit[] {
  return limits.filter((one): one is KnownLimit => typeof one.limit_um === "number");
}

function largest(errors: readonly LengthError[]) {
  return errors.reduce((most, { error_um }) => Math.max(most, Math.abs(error_um)), 0);
}

function counted(errors: readonly LengthError[]) {
  if (errors.length === 0) return t("ui-no-length-yet");
  return t("ui-lengths-largest-error", { count: errors.length, value: measured(largest(errors), "µm", 1) });
}
