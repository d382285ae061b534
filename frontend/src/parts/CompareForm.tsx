import { type ReactNode, useId, useState } from "react";

import { comparePart, removePart, sendPart } from "../api/partCommands";
import type { KeptPartView, NewComparison, ReadingPart } from "../api/wire";
import look from "../controls/Control.module.css";
import fields from "../controls/Field.module.css";
import { FileChooser } from "../controls/FileChooser";
import { figures } from "../controls/format";
import { fromTyped, lengthFigures, typed, unitOf } from "../controls/lengths";
import { PressButton } from "../controls/PressButton";
import { Busy } from "../controls/Progress";
import { QualityMark } from "../controls/QualityMark";
import { UnitInput } from "../controls/UnitInput";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import styles from "./ComparePanel.module.css";
import { PartUnit, type Unit } from "./PartUnit";

interface CompareFormProps {
  scan: string;
  parts: KeptPartView[];
  reading: ReadingPart | null;
  children?: ReactNode;
}

const ACCEPTED = ".stl,.step,.stp";
/** Of a part that was never compared. */
const USUAL_MM = 0.1;

/** Which part, in which unit, with which tolerance. */
export function CompareForm({ scan, parts, reading, children }: CompareFormProps) {
  const [chosen, setChosen] = useState<string | null>(null);
  const part = parts.find(({ id }) => id === chosen) ?? parts[0];
  const [newest, setNewest] = useState(parts[0]?.id);
  if (newest !== parts[0]?.id) {
    setNewest(parts[0]?.id);
    setChosen(null);
  }
  const take = async ([file]: FileList) => void (file && (await sendPart(file)));
  if (reading) {
    const text = reading.is_sent ? t("ui-reading-the-part") : t("ui-sending-the-part");
    return <Busy text={`${isolated(reading.name)} · ${text}`} fraction={reading.share} />;
  }
  return (
    <>
      {part && (
        <div className={fields.field}>
          <label className={fields.label} htmlFor="compared-part">
            {t("ui-compared-part")}
          </label>
          <select
            id="compared-part"
            className={`${look.input} ${fields.input}`}
            value={part.id}
            onChange={(event) => setChosen(event.target.value)}
          >
            {parts.map((one) => (
              <option key={one.id} value={one.id}>
                {one.name}
              </option>
            ))}
          </select>
        </div>
      )}
      {part && (
        <ChosenPart key={part.id} scan={scan} part={part} usual={parts.find(({ upper_mm }) => upper_mm !== null)} />
      )}
      <div className={styles.drop} data-first={!part || undefined}>
        <p>{part ? t("ui-drop-another-part-here") : t("ui-drop-the-part-here")}</p>
        <FileChooser id="part-file" accept={ACCEPTED} onFiles={take}>
          {t("ui-choose-a-file")}
        </FileChooser>
      </div>
      {children}
    </>
  );
}

function ChosenPart({ scan, part, usual }: { scan: string; part: KeptPartView; usual: KeptPartView | undefined }) {
  const [unit, setUnit] = useState<Unit | "">(part.has_unit ? "" : (part.unit as Unit | ""));
  const [body, setBody] = useState<number | null>(part.body);
  const [locked, setLocked] = useState<string[]>(part.locked);
  const before = part.upper_mm === null ? usual : part;
  const [lower, setLower] = useState(() => typed(before?.lower_mm ?? -USUAL_MM, "mm"));
  const [upper, setUpper] = useState(() => typed(before?.upper_mm ?? USUAL_MM, "mm"));
  const lower_mm = fromTyped(lower, "mm");
  const upper_mm = fromTyped(upper, "mm");
  const ordered = lower_mm < upper_mm;
  const why =
    !part.has_unit && !unit ? t("ui-choose-the-unit-first") : ordered ? "" : t("ui-lower-must-be-below-upper");
  const start = async () => {
    const wish = { part: part.id, unit, body, lower_mm, upper_mm, locked } as NewComparison;
    await comparePart(scan, wish);
  };
  return (
    <>
      <p className={styles.note}>{factsOf(part)}</p>
      {part.notes.map((note) => (
        <p key={note} className={styles.warning}>
          <QualityMark quality="attention" size="1.25rem" />
          <span>{note}</span>
        </p>
      ))}
      {!part.has_unit && <PartUnit part={part} scan={scan} unit={unit} onChange={setUnit} />}
      {part.bodies > 1 && <Bodies count={part.bodies} body={body} onChange={setBody} />}
      <fieldset className={styles.tolerance}>
        <legend className={fields.label}>{t("ui-tolerance")}</legend>
        <Limit name={t("ui-lower")} text={lower} onText={setLower} />
        <Limit name={t("ui-upper")} text={upper} onText={setUpper} />
      </fieldset>
      <PressButton kind="primary" disabled={why !== ""} why={why} onPress={start}>
        {t("ui-compare")}
      </PressButton>
      <Locks locked={locked} onChange={setLocked} />
      <PressButton kind="quiet" onPress={async () => void (await removePart(part.id))}>
        {t("ui-remove-name", { name: isolated(part.name) })}
      </PressButton>
    </>
  );
}

function factsOf(part: KeptPartView): string {
  const facts = [part.form, t("ui-n-triangles", { n: part.triangles })];
  if (part.has_unit) facts.push(`${part.size.map((one) => lengthFigures(one, "mm", 1)).join(" × ")} ${unitOf("mm")}`);
  facts.push(part.is_closed ? t("ui-closed-surface") : t("ui-open-surface"));
  return facts.join(" · ");
}

function Limit({ name, text, onText }: { name: string; text: string; onText: (text: string) => void }) {
  const wrong = Number.isNaN(fromTyped(text, "mm"));
  const id = useId();
  return (
    <div className={fields.field}>
      <label className={fields.label} htmlFor={id}>
        {name}
      </label>
      <UnitInput id={id} value={text} unit={unitOf("mm")} aria-invalid={wrong || undefined} onText={onText} />
    </div>
  );
}

function Bodies({
  count,
  body,
  onChange,
}: {
  count: number;
  body: number | null;
  onChange: (body: number | null) => void;
}) {
  return (
    <label className={fields.field}>
      <span className={fields.label}>{t("ui-the-file-has-bodies", { count })}</span>
      <select
        className={`${look.input} ${fields.input}`}
        value={body ?? ""}
        onChange={(event) => onChange(event.target.value ? Number(event.target.value) : null)}
      >
        <option value="">{t("ui-all-bodies-together")}</option>
        {Array.from({ length: count }, (_, i) => (
          <option key={i} value={i + 1}>
            {t("ui-body-number", { n: figures(i + 1, 0) })}
          </option>
        ))}
      </select>
    </label>
  );
}

const MOTIONS = ["x", "y", "z", "rx", "ry", "rz"];

/** Motions of the part that its scanned surface does not fix, as of a cylinder. */
function Locks({ locked, onChange }: { locked: string[]; onChange: (locked: string[]) => void }) {
  const toggle = (name: string) =>
    onChange(locked.includes(name) ? locked.filter((one) => one !== name) : [...locked, name]);
  return (
    <details className={styles.locks} open={locked.length > 0}>
      <summary>{t("ui-locked-motions")}</summary>
      <p className={styles.note}>{t("ui-locked-motions-are-for")}</p>
      <div className={styles.motions} role="group" aria-label={t("ui-locked-motions")}>
        {MOTIONS.map((name) => (
          <button
            key={name}
            type="button"
            className={look.button}
            aria-pressed={locked.includes(name)}
            onClick={() => toggle(name)}
          >
            {name}
          </button>
        ))}
      </div>
    </details>
  );
}
