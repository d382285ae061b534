import { useEffect, useState } from "react";

import { colourBy } from "../api/viewCommands";
import type { Legend, Measure } from "../api/viewTypes";
import { fromTyped, unitOf } from "../parts/lengths";
import { PressButton } from "../parts/PressButton";
import { UnitInput } from "../parts/UnitInput";
import { useBarred } from "../state/control";
import { t } from "../state/language";
import { useLive } from "../state/store";
import styles from "./ColourPanel.module.css";
import { decimalsOf, inShown, MEASURES } from "./LegendBar";

const ORDER: Measure[] = ["height", "intensity", "uncertainty", "age", "deviation"];

/** What the clouds are coloured by, and within which limits: for all who watch. */
export function ColourPanel() {
  const measure = useLive((s) => s.view?.measure ?? "height");
  const legend = useLive((s) => s.view?.legend ?? null);
  const barred = useBarred() !== "";
  const fitted = useLive((s) => (s.view?.fits.length ?? 0) > 0);
  return (
    <>
      <h2 className={styles.title}>{t("Colour by")}</h2>
      <div role="radiogroup" aria-label={t("Colour by")} className={styles.measures}>
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
              {missing && <span className={styles.why}>{t("Fit a shape first")}</span>}
            </button>
          );
        })}
      </div>
      {legend && <Limits key={legend.measure} legend={legend} />}
    </>
  );
}

/** As a field takes it; nothing is not minus nothing. */
function plain(value: number, decimals: number): string {
  return value.toFixed(decimals).replace(/^-(?=[0.]*$)/, "");
}

/** Automatic limits follow what is shown; those typed in stay. */
function Limits({ legend }: { legend: Legend }) {
  const unit = unitOf(legend.unit);
  const [low, setLow] = useState("");
  const [high, setHigh] = useState("");
  const [typed, setTyped] = useState(false);
  useEffect(() => {
    if (typed) return;
    const ends = inShown(legend);
    const decimals = decimalsOf(ends);
    setLow(plain(ends.low, decimals));
    setHigh(plain(ends.high, decimals));
  }, [legend, typed, unit]);
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
        {t("Limits")} <span className={styles.how}>{legend.automatic ? t("automatic") : t("set by hand")}</span>
      </h2>
      <div className={styles.limits}>
        <UnitInput unit={unit} long={unit.length > 3} value={low} onText={type(setLow)} aria-label={t("Lower limit, {unit}", { unit })} />
        <UnitInput unit={unit} long={unit.length > 3} value={high} onText={type(setHigh)} aria-label={t("Upper limit, {unit}", { unit })} />
      </div>
      {typed && wrong && <p className={styles.wrong}>{t("The lower limit must be below the upper.")}</p>}
      <div className={styles.acts}>
        <PressButton onPress={apply} disabled={!typed || wrong}>
          {t("Use these limits")}
        </PressButton>
        {!legend.automatic && <PressButton onPress={automatic}>{t("Automatic")}</PressButton>}
      </div>
    </>
  );
}
