import { chooseLanguage, LANGUAGES, nameOf, t, useLanguage } from "../state/language";
import { chooseUnits, type Units, useUnits } from "../state/units";
import { Chips } from "./Chips";

/** The pressed button keeps the focus while the page reloads. */
function focusOn(group: string): void {
  requestAnimationFrame(() => {
    if (document.activeElement !== document.body) return;
    document.getElementById(group)?.querySelector<HTMLElement>("[aria-pressed=true]")?.focus();
  });
}

/** The language of this browser; each language has its own name. */
export function ChooseLanguage({ id }: { id: string }) {
  const language = useLanguage();
  const choose = async (code: string) => {
    await chooseLanguage(code);
    focusOn(id);
  };
  const options = LANGUAGES.map((code) => ({ value: code, label: nameOf(code), lang: code }));
  return (
    <Chips id={id} label={t("ui-language")} options={options} value={language} onChange={(code) => void choose(code)} />
  );
}

/** The unit in which this browser shows and accepts lengths. */
export function ChooseUnits({ id }: { id: string }) {
  const units = useUnits();
  const choose = (now: Units) => {
    chooseUnits(now);
    focusOn(id);
  };
  const options: { value: Units; label: string }[] = [
    { value: "metric", label: "mm, µm" },
    { value: "inch", label: "inch, µin" },
  ];
  return <Chips id={id} label={t("ui-lengths")} options={options} value={units} onChange={choose} />;
}
