import { type KeyboardEvent, useRef } from "react";

import { sendCommand } from "../api/guideCommands";
import type { ObjectGeometry } from "../api/types";
import type { BlockGeometry, BoardGeometry, Choice, ChoiceOption } from "../api/wire";
import { ObjectDrawing } from "../object/ObjectDrawing";
import { CheckIcon } from "../parts/icons";
import { lengthFigures, measured, unitOf } from "../parts/lengths";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import styles from "./ChoicesPicture.module.css";

/** What is used: one of each kind, and the object as its certificate draws it. */
export function ChoicesPicture({ choices, object }: { choices: Choice[]; object: ObjectGeometry | null }) {
  return (
    <div className={styles.picture}>
      <div className={styles.choices}>
        {choices.map((choice) => (
          <ChoiceGroup key={choice.field} choice={choice} />
        ))}
      </div>
      {object && (
        <div className={styles.object}>
          <ObjectDrawing object={object} face={null} label={t("ui-selected-object")} />
          <p className={styles.caption}>{object.kind === "block" ? blockSize(object) : boardSize(object)}</p>
        </div>
      )}
    </div>
  );
}

function blockSize(block: BlockGeometry): string {
  const first = block.edges_x_mm[0] ?? 0;
  const last = block.edges_x_mm[block.edges_x_mm.length - 1] ?? 0;
  const parts = [last - first, block.back_y_mm - block.front_y_mm, block.crest_z_mm - block.base_z_mm];
  const lengths = parts.map((part) => lengthFigures(part, "mm", 3)).join(" × ");
  return `${lengths} ${unitOf("mm")}, ${t("ui-merlons", { n: block.edges_x_mm.length / 2 })}`;
}

function boardSize({ inner_corners, square_mm }: BoardGeometry): string {
  const [columns, rows] = inner_corners;
  const square = measured(square_mm, "mm", 3);
  return t("ui-inner-corners-squares-of", { columns, rows, square });
}

function ChoiceGroup({ choice }: { choice: Choice }) {
  const group = useRef<HTMLDivElement>(null);
  const choose = (option: ChoiceOption | undefined) => {
    if (option && option.id !== choice.selected) {
      void sendCommand("flow", "choose", { field: choice.field, id: option.id });
    }
  };
  const onKey = (event: KeyboardEvent) => {
    const step = { ArrowDown: 1, ArrowRight: 1, ArrowUp: -1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    const buttons = Array.from(group.current?.querySelectorAll("button") ?? []);
    const at = buttons.indexOf(document.activeElement as HTMLButtonElement);
    buttons[(at + step + buttons.length) % buttons.length]?.focus();
  };
  return (
    <section className={styles.group}>
      <h3 className={styles.heading}>{choice.title}</h3>
      <div ref={group} role="radiogroup" aria-label={choice.title} onKeyDown={onKey} className={styles.options}>
        {choice.options.map((option) => (
          <button
            key={option.id}
            type="button"
            role="radio"
            aria-checked={option.id === choice.selected}
            className={styles.option}
            onClick={() => choose(option)}
          >
            <span className={styles.tick}>{option.id === choice.selected && <CheckIcon size="1.125rem" />}</span>
            <span>
              <span className={styles.label}>{isolated(option.label)}</span>
              <span className={styles.detail}>{option.detail}</span>
            </span>
          </button>
        ))}
      </div>
    </section>
  );
}
