import { useEffect, useState } from "react";
import type { Measure } from "../api/types";
import { colourBy } from "../api/viewCommands";
import type { Legend } from "../api/wire";
import { fieldFigures, fromTyped, unitOf } from "../controls/lengths";
import { PressButton } from "../controls/PressButton";
import { UnitInput } from "../controls/UnitInput";
import { useBarred } from "../state/control";
import { t } from "../state/language";
import { useLive } from "../state/store";
import styles from "./ColourPanel.module.css";
import { decimalsOf, inDisplayedUnit, MEASURES } from "./LegendBar";

const ORDER: Measure[] = ["height", "intensity", "uncertainty", "age", "deviation"];

/** The quantity and limits of the colours, for all viewers. */
export function ColourPanel() {
  const measure = useLive((s) => s.view?.measure ?? "height");
  const legend = useLive((s) => s.view?.legend ?? null);
  const barred = useBarred() !== "";
  const fitted = useLive((s) => (s.view?.fits.length ?? 0) > 0);
  return (
    <>
      <h2 className={styles.title}>{t("ui-colour-by")}</h2>
      <div role="radiogroup" aria-label={t("ui-colour-by")} className={styles.measures}>
        {ORDER.map((one) => {
          const missing = one === "deviation" && !fitted;
          const off = missing || barred;
          return (
            <button
              key={one}
              type="button"
              role="radio"
              aria-checked={measure === one}
              aria-disabled={off || undefined}
              className={styles.measure}
              onClick={() => !off && void colourBy(one)}
            >
              {t(MEASURES[one].name)}
              {missing && <span className={styles.why}>{t("ui-fit-a-shape-first")}</span>}
            </button>
          );
        })}
      </div>
      {legend && <Limits key={legend.measure} legend={legend} />}
    </>
  );
}

/** Automatic limits follow the view; typed ones stay. */
function Limits({ legend }: { legend: Legend }) {
  const unit = unitOf(legend.unit);
  const [low, setLow] = useState("");
  const [high, setHigh] = useState("");
  const [typed, setTyped] = useState(false);
  const ends = inDisplayedUnit(legend);
  const decimals = decimalsOf(ends);
  const [lowest, highest] = [fieldFigures(ends.low, decimals), fieldFigures(ends.high, decimals)];
  useEffect(() => {
    if (typed) return;
    setLow(lowest);
    setHigh(highest);
  }, [lowest, highest, typed]);
  const type = (set: (text: string) => void) => (text: string) => {
    setTyped(true);
    set(text);
  };
  const limits: [number, number] = [fromTyped(low || "–", legend.unit), fromTyped(high || "–", legend.unit)];
  const wrong = limits.some((limit) => !Number.isFinite(limit)) || limits[0] >= limits[1];
  const apply = async () => {
    if (await colourBy(legend.measure, limits)) setTyped(false);
  };
  const automatic = async () => {
    setTyped(false);
    await colourBy(legend.measure);
  };
  return (
    <>
      <h2 className={styles.title}>
        {t("ui-limits")}{" "}
        <span className={styles.how}>{legend.automatic ? t("ui-automatic-lowercase") : t("ui-manual")}</span>
      </h2>
      <div className={styles.limits}>
        <UnitInput
          unit={unit}
          long={unit.length > 3}
          value={low}
          onText={type(setLow)}
          aria-label={t("ui-lower-limit", { unit })}
        />
        <UnitInput
          unit={unit}
          long={unit.length > 3}
          value={high}
          onText={type(setHigh)}
          aria-label={t("ui-upper-limit", { unit })}
        />
      </div>
      {typed && wrong && <p className={styles.wrong}>{t("ui-lower-limit-must-below-upper")}</p>}
      <div className={styles.acts}>
        <PressButton onPress={apply} disabled={!typed || wrong}>
          {t("ui-apply-limits")}
        </PressButton>
        {!legend.automatic && <PressButton onPress={automatic}>{t("ui-automatic")}</PressButton>}
      </div>
    </>
  );
}
