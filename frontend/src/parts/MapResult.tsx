import { useEffect } from "react";

import { hideMap, type MapMode, removeMap, showMap } from "../api/partCommands";
import type { ComparisonFile, PlaceOnMap } from "../api/wire";
import look from "../controls/Control.module.css";
import { Download } from "../controls/Download";
import { figures, moment } from "../controls/format";
import { lengthFigures, measured, signedLength } from "../controls/lengths";
import { PressButton } from "../controls/PressButton";
import { QualityMark } from "../controls/QualityMark";
import type { PlainId } from "../messages/text";
import { useBarred } from "../state/control";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import styles from "./ComparePanel.module.css";
import { DECISIONS, MODES, Swatch } from "./MapLegend";
import { PlaceCard } from "./PlaceCard";
import { useShownMap } from "./shownMap";

type Profile = NonNullable<ComparisonFile["profile"]>["decision"];

const WORDS: Record<Profile, { name: PlainId; quality: "good" | "bad" | "attention" }> = {
  pass: { name: "ui-the-whole-surface-is-in", quality: "good" },
  fail: { name: "ui-the-surface-is-out", quality: "bad" },
  undecided: { name: "ui-the-surface-is-undecided", quality: "attention" },
};

interface MapResultProps {
  result: ComparisonFile;
  place: PlaceOnMap | null;
  onClosePlace: () => void;
  onAgain: () => void;
}

/** What was found of a scan: the word, the counts, how sure it is, and its files. */
export function MapResult({ result, place, onClosePlace, onAgain }: MapResultProps) {
  const shown = useShownMap();
  const mode = shown?.result.scan === result.scan ? shown.legend.mode : null;
  const scatter = result.uncertainty === "scatter";
  useEffect(() => {
    if (!mode) onClosePlace();
  }, [mode, onClosePlace]);
  return (
    <>
      <Word result={result} />
      <Modes result={result} mode={mode} />
      {mode &&
        (place && place.state !== "nothing" ? (
          <PlaceCard place={place} onClose={onClosePlace} />
        ) : (
          <p className={styles.note}>{t("ui-tap-a-place-of-the-map")}</p>
        ))}
      <Figures result={result} />
      {(result.warnings ?? []).map((text) => (
        <p key={text} className={styles.warning}>
          <QualityMark quality="attention" size="1.25rem" />
          <span>{text}</span>
        </p>
      ))}
      <div className={styles.acts}>
        <PressButton onPress={onAgain}>{t("ui-compare-again")}</PressButton>
        <Download href={`/api/scans/${encodeURIComponent(result.scan)}/map.ply`}>{t("ui-map-ply")}</Download>
        <Download href={`/api/scans/${encodeURIComponent(result.scan)}/deviation.json`}>{t("ui-result-json")}</Download>
        <PressButton kind="quiet" onPress={async () => void (await removeMap(result.scan))}>
          {t("ui-remove-the-map")}
        </PressButton>
      </div>
      <p className={styles.note}>
        {t("ui-compared-with-part-at", { part: isolated(result.part), at: moment(result.made_at), unit: result.unit })}{" "}
        {scatter ? "" : t("ui-decided-by-rule", { percent: measured(95, "%") })}
      </p>
    </>
  );
}

function Word({ result }: { result: ComparisonFile }) {
  const { profile, uncertainty } = result;
  const word = profile ? WORDS[profile.decision] : null;
  return (
    <div className={styles.word} data-quality={word?.quality ?? "neutral"}>
      <QualityMark quality={word?.quality ?? "neutral"} size="2rem" />
      <div>
        <p className={styles.verdict}>{t(word?.name ?? "ui-nothing-is-decided")}</p>
        <p className={styles.limits}>
          {t("ui-tolerance-from-to", {
            lower: signedLength(result.lower_mm, "mm", 3),
            upper: signedLength(result.upper_mm, "mm", 3),
          })}
          {profile && ` · ${t("ui-within-with-probability", { percent: percentOf(profile.probability) })}`}
          {uncertainty === "scatter" && ` · ${t("ui-only-scatter-is-known")}`}
        </p>
      </div>
    </div>
  );
}

function percentOf(share: number): string {
  const percent = 100 * share;
  return measured(percent, "%", percent > 0.05 && percent < 99.95 ? 1 : 0);
}

function Modes({ result, mode }: { result: ComparisonFile; mode: MapMode | null }) {
  const barred = useBarred() !== "";
  const modes: MapMode[] =
    result.uncertainty === "scatter" ? ["deviation"] : ["significance", "deviation", "uncertainty"];
  const shown = [
    ...modes.map((one) => ({ mode: one, label: t(MODES[one].name) })),
    { mode: null, label: t("ui-cloud-of-the-scan") },
  ];
  return (
    <div className={styles.modes} role="group" aria-label={t("ui-what-the-view-shows")}>
      {shown.map((one) => (
        <button
          key={one.label}
          type="button"
          className={look.button}
          aria-pressed={one.mode === mode}
          aria-disabled={barred || undefined}
          onClick={() => !barred && void (one.mode ? showMap(result.scan, one.mode) : hideMap(result.scan))}
        >
          {one.label}
        </button>
      ))}
    </div>
  );
}

function Figures({ result }: { result: ComparisonFile }) {
  const { counts } = result;
  const u = result.standard_uncertainty_um ?? null;
  const chance = result.out_by_chance ?? null;
  const residual = result.residual_um ?? null;
  const cells = Math.max(result.cells, 1);
  const share = (count: number) => `${figures(count, 0)} (${percentOf(count / cells)})`;
  const rows: [string, string][] = [
    [t("ui-deviation-median"), signedLength(result.median_um, "µm", 1)],
    [
      t("ui-deviation-range"),
      `${lengthFigures(result.least_um, "µm", 0, true)} … ${signedLength(result.most_um, "µm", 0)}`,
    ],
    u === null
      ? [t("ui-scatter-median"), measured(result.scatter_um, "µm", 1)]
      : [t("ui-uncertainty-median"), measured(2 * u, "µm", 1)],
  ];
  if (chance !== null) rows.push([t("ui-out-by-chance"), figures(chance, 2)]);
  if (residual !== null) rows.push([t("ui-residual-of-alignment"), measured(residual, "µm", 1)]);
  rows.push([t("ui-points-beyond-2-mm"), figures(result.beyond, 0)]);
  rows.push([t("ui-points-at-edges"), figures(result.at_edges, 0)]);
  return (
    <dl className={styles.rows}>
      {DECISIONS.map(({ kind, name, colours }) =>
        kind === "unscanned" ? null : (
          <div key={kind} className={styles.row}>
            <dt>
              <Swatch colours={colours} /> {t("ui-cells-that-are", { decision: t(name) })}
            </dt>
            <dd>{share(counts[kind])}</dd>
          </div>
        ),
      )}
      {rows.map(([name, value]) => (
        <div key={name} className={styles.row}>
          <dt>{name}</dt>
          <dd>{value}</dd>
        </div>
      ))}
    </dl>
  );
}
