import { type ReactNode, useState } from "react";
import type { AskedShape, ShapeName } from "../api/types";
import { relateShapes, undoShapes } from "../api/viewCommands";
import type { FittedShape } from "../api/wire";
import look from "../controls/Control.module.css";
import { ConeIcon, CylinderIcon, MeasureIcon, PlaneIcon, SphereIcon, UndoIcon } from "../controls/icons";
import { useBarred } from "../state/control";
import { t } from "../state/language";
import { useLive } from "../state/store";
import { FitCard } from "./FitCard";
import styles from "./MeasurePanel.module.css";
import { RelationCard } from "./RelationCard";
import { NAMES, nameOf } from "./shapeNames";

const SHAPES: { name: ShapeName; icon: ReactNode }[] = [
  { name: "plane", icon: <PlaneIcon /> },
  { name: "cylinder", icon: <CylinderIcon /> },
  { name: "sphere", icon: <SphereIcon /> },
  { name: "cone", icon: <ConeIcon /> },
];

/** Fitted shapes and dimensions between them, the newest first. */
export function MeasurePanel({ onPick }: { onPick: (shape: AskedShape) => void }) {
  const fits = useLive((s) => s.view?.fits) ?? [];
  const relations = useLive((s) => s.view?.relations) ?? [];
  const barred = useBarred() !== "";
  const busy = useLive((s) => s.view?.busy ?? "");
  const some = useLive((s) => Boolean(s.view?.legend));
  const why = busy ? busy : some ? "" : t("ui-no-cloud-picture-yet-scan-display");
  const off = barred || why !== "";
  const ask = (shape: AskedShape) => !off && onPick(shape);
  const newest = Math.max(0, ...fits.map((one) => one.id));
  const cards = [
    ...fits.map((one) => ({ id: one.id, card: <FitCard fitted={one} last={one.id === newest} /> })),
    ...relations.map((one) => ({ id: one.id, card: <RelationCard relation={one} fits={fits} /> })),
  ];
  return (
    <>
      <h2 className={styles.title}>{t("ui-fit-a-shape")}</h2>
      <button
        type="button"
        className={`${look.button} ${styles.any}`}
        aria-disabled={off || undefined}
        onClick={() => ask("any")}
      >
        <MeasureIcon />
        {t("ui-find-the-shape")}
      </button>
      <div className={styles.shapes}>
        {SHAPES.map((shape) => (
          <button
            key={shape.name}
            type="button"
            className={`${look.button} ${styles.shape}`}
            aria-disabled={off || undefined}
            onClick={() => ask(shape.name)}
          >
            {shape.icon}
            {t(NAMES[shape.name])}
          </button>
        ))}
      </div>
      {why && (
        <p className={styles.why} role="status">
          {why}
        </p>
      )}
      {!barred && <Changes fits={fits} busy={busy !== ""} />}
      {cards
        .sort((a, b) => b.id - a.id)
        .map(({ id, card }) => (
          <div key={id}>{card}</div>
        ))}
    </>
  );
}

/** Measuring between two shapes, and taking the last change back. */
function Changes({ fits, busy }: { fits: readonly FittedShape[]; busy: boolean }) {
  const canUndo = useLive((s) => s.view?.can_undo ?? false);
  const [choosing, setChoosing] = useState(false);
  const [first, setFirst] = useState<number | null>(null);
  const [one, other] = fits;
  const begin = () => {
    setFirst(null);
    if (one && other && fits.length === 2) void relateShapes(one.id, other.id);
    else setChoosing(true);
  };
  const choose = (id: number) => {
    if (first === null || first === id) return setFirst(first === id ? null : id);
    setChoosing(false);
    return void relateShapes(first, id);
  };
  const many = fits.length > 1;
  if (!many && !canUndo) return null;
  return (
    <div className={styles.changes}>
      {many && !choosing && (
        <button
          type="button"
          className={`${look.button} ${styles.between}`}
          aria-disabled={busy || undefined}
          onClick={() => !busy && begin()}
        >
          {one && other && fits.length === 2
            ? t("ui-measure-between-names", { first: nameOf(one), second: nameOf(other) })
            : t("ui-measure-between-two")}
        </button>
      )}
      {many && choosing && (
        <fieldset className={styles.choice}>
          <legend>{t(first === null ? "ui-choose-two-shapes" : "ui-choose-the-second-shape")}</legend>
          {fits.map((fit) => (
            <button
              key={fit.id}
              type="button"
              className={look.button}
              aria-pressed={fit.id === first}
              onClick={() => choose(fit.id)}
            >
              {nameOf(fit)}
            </button>
          ))}
          <button type="button" className={look.button} onClick={() => setChoosing(false)}>
            {t("ui-cancel")}
          </button>
        </fieldset>
      )}
      {canUndo && (
        <button type="button" className={`${look.button} ${styles.undo}`} onClick={() => void undoShapes()}>
          <UndoIcon size="1.25rem" />
          {t("ui-undo")}
        </button>
      )}
    </div>
  );
}
