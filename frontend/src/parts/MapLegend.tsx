import type { ShownMap } from "../api/wire";
import { figures } from "../controls/format";
import { inUnit, unitOf } from "../controls/lengths";
import type { PlainId } from "../messages/text";
import look from "../scan/LegendBar.module.css";
import { t } from "../state/language";
import styles from "./MapLegend.module.css";

export const MODES: Record<ShownMap["legend"]["mode"], { name: PlainId; legend: PlainId }> = {
  deviation: { name: "ui-deviation", legend: "ui-deviation-outside-is-positive" },
  significance: { name: "ui-significance", legend: "ui-decision-with-95-percent" },
  uncertainty: { name: "ui-uncertainty", legend: "ui-uncertainty-u-k-2" },
};

/** The colours of the station (app/crenel/parts/compare/maths_map_colours.py). */
export const DECISIONS: { kind: "inside" | "outside" | "undecided" | "unscanned"; name: PlainId; colours: string[] }[] =
  [
    { kind: "inside", name: "ui-in", colours: ["rgb(0 140 104)"] },
    { kind: "outside", name: "ui-out", colours: ["rgb(206 60 30)"] },
    { kind: "undecided", name: "ui-undecided", colours: ["rgb(200 204 210)", "rgb(150 156 164)"] },
    { kind: "unscanned", name: "ui-not-scanned", colours: ["rgb(244 245 247)"] },
  ];

export interface Mark {
  /** 0 to 1 from left to right. */
  at: number;
  text: string;
  /** It is a limit of the tolerance. */
  limit: boolean;
}

/** Numbers below a scale: its ends, zero and the limits; those that would touch another one are left out. */
export function marksOf({ legend, result }: ShownMap): Mark[] {
  const { low_um, high_um, mode } = legend;
  const limits = mode === "deviation" ? [1000 * result.lower_mm, 1000 * result.upper_mm] : [];
  const places = [low_um, high_um, ...limits, 0, ...(mode === "uncertainty" ? [(low_um + high_um) / 2] : [])];
  const found: (Mark & { value: number })[] = [];
  for (const value of places) {
    const at = (value - low_um) / (high_um - low_um);
    if (at < 0 || at > 1 || found.some((one) => Math.abs(one.at - at) < APART)) continue;
    found.push({ value, at, text: "", limit: limits.includes(value) });
  }
  const span = inUnit(high_um - low_um, "µm");
  const decimals = span >= 40 ? 0 : span >= 4 ? 1 : 2;
  return found
    .map(({ value, ...mark }) => ({ ...mark, text: figures(inUnit(value, "µm"), decimals) }))
    .sort((a, b) => a.at - b.at);
}

const APART = 0.14;

/** What the colours of the map mean, with its numbers. */
export function MapLegend({ shown }: { shown: ShownMap }) {
  const { legend } = shown;
  return (
    <figure className={look.legend} data-map-legend>
      <figcaption className={look.title}>
        {t(MODES[legend.mode].legend)}
        {legend.mode !== "significance" && <span className={look.unit}>{unitOf("µm")}</span>}
      </figcaption>
      {legend.mode === "significance" ? <Decisions /> : <Scale shown={shown} />}
    </figure>
  );
}

function Scale({ shown }: { shown: ShownMap }) {
  const marks = marksOf(shown);
  return (
    <>
      <div className={look.bar} style={{ background: `linear-gradient(to right, ${shown.legend.colours.join(", ")})` }}>
        <div className={styles.ticks}>
          {marks
            .filter(({ limit }) => limit)
            .map(({ at }) => (
              <span key={at} className={styles.tick} style={{ left: `${100 * at}%` }} />
            ))}
        </div>
      </div>
      <div className={styles.marks}>
        {marks.map(({ at, text, limit }) => (
          <span
            key={at}
            className={styles.mark}
            data-limit={limit || undefined}
            style={{ left: `${100 * at}%`, translate: `${-100 * at}% 0` }}
          >
            {text}
          </span>
        ))}
      </div>
    </>
  );
}

function Decisions() {
  return (
    <ul className={styles.decisions}>
      {DECISIONS.map(({ kind, name, colours }) => (
        <li key={kind}>
          <Swatch colours={colours} />
          {t(name)}
        </li>
      ))}
    </ul>
  );
}

/** A colour; of two, a hatching. */
export function Swatch({ colours: [first, second] }: { colours: string[] }) {
  const hatched = `repeating-linear-gradient(135deg, ${first} 0 3px, ${second} 3px 6px)`;
  return <span className={styles.swatch} style={{ background: second ? hatched : first }} aria-hidden="true" />;
}
