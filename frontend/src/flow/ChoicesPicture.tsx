import { Fragment } from "react";

import { setValue } from "../api/guideCommands";
import type { ObjectGeometry } from "../api/types";
import type { BlockGeometry, BoardGeometry, Choice } from "../api/wire";
import { lengthFigures, measured, unitOf } from "../controls/lengths";
import { PressButton } from "../controls/PressButton";
import { FORMS, formsOf } from "../datasheets/forms";
import { ObjectDrawing } from "../object/ObjectDrawing";
import { t } from "../state/language";
import { go } from "../state/router";
import { useLive } from "../state/store";
import { ChoiceGroup } from "./ChoiceGroup";
import styles from "./ChoicesPicture.module.css";

/** What is used: one of each kind, and the object as its certificate draws it. */
export function ChoicesPicture({ choices, object }: { choices: Choice[]; object: ObjectGeometry | null }) {
  return (
    <div className={styles.picture}>
      <div className={styles.choices}>
        {choices.map(({ field, ...choice }) => (
          <Fragment key={field}>
            <ChoiceGroup {...choice} onChoose={(id) => void setValue("flow", "choose", { field, id })} />
            {choice.options.length === 0 && <NothingToChoose field={field} />}
          </Fragment>
        ))}
        <div className={styles.more}>
          <PressButton free kind="quiet" onPress={() => go("datasheets")}>
            {t("ui-datasheets")}
          </PressButton>
        </div>
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

/** What is missing, and where it is made. */
function NothingToChoose({ field }: { field: string }) {
  const admin = useLive((s) => s.session?.you?.role === "admin");
  if (field === "sensor") {
    return (
      <div className={styles.missing}>
        <p>
          {t("ui-nothing-to-choose")} {t("ui-made-on-the-devices-page")}
        </p>
        {admin && (
          <PressButton free onPress={() => go("devices")}>
            {t("ui-devices")}
          </PressButton>
        )}
      </div>
    );
  }
  const kind = field === "arm" ? "arm" : "object";
  return (
    <div className={styles.missing}>
      <p>{t("ui-nothing-to-choose")}</p>
      {formsOf(kind).map((name) => (
        <PressButton key={name} free onPress={() => go("datasheets", `new/${name}`)}>
          {t("ui-new-of-kind", { title: t(FORMS[name].title) })}
        </PressButton>
      ))}
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
