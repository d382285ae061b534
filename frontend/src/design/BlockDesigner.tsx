import { useEffect, useState } from "react";

import { notifyOfError } from "../api/commands";
import { fileOf } from "../api/datasheetCommands";
import { type BlockFile, getBlockFile } from "../api/designCommands";
import { getFile } from "../api/http";
import type { DatasheetRow } from "../api/wire";
import { TextField } from "../controls/TextField";
import { useOnlyViews } from "../state/control";
import { currentLanguage, t } from "../state/language";
import { BlockResult } from "./BlockResult";
import { BlockSizes } from "./BlockSizes";
import { givenSizes, NO_SIZES, sizesOf } from "./blockSizes";
import { Choice } from "./Choice";
import styles from "./Design.module.css";
import { jsonFile } from "./DesignFiles";
import { DesignPage } from "./DesignPage";
import { NumberSlider } from "./NumberSlider";
import { firstFields, numbersOf, SLIDER_NAMES, SLIDERS, withDatasheet } from "./sensorNumbers";
import { useBlockDesign } from "./useBlockDesign";

interface BlockDesignerProps {
  rows: DatasheetRow[];
  onTake: (document: Record<string, unknown>) => void;
  onBack: () => void;
}

/** A block for a sensor by its numbers: its drawing with the laser line, its accuracy, its files. */
export function BlockDesigner({ rows, onTake, onBack }: BlockDesignerProps) {
  const usable = rows.filter((row) => !row.retired && !row.problem);
  const sensors = usable.filter(({ kind }) => kind === "sensor");
  const arms = usable.filter(({ form }) => form === "arm");
  const [fields, setFields] = useState(firstFields);
  const [sizes, setSizes] = useState(NO_SIZES);
  const [sensor, setSensor] = useState(() => sensors.find(({ connected }) => connected)?.file ?? "");
  const [arm, setArm] = useState(() => arms.find(({ connected }) => connected)?.file ?? "");
  const [name, setName] = useState(t("ui-crenellated-block"));
  const [known, setKnown] = useState("");
  const chosen = sensors.find(({ file }) => file === sensor);
  const address = chosen ? fileOf(chosen) : "";
  useEffect(() => {
    if (!address) return setKnown("");
    let wanted = true;
    getFile(address)
      .then(async (file) => JSON.parse(await file.text()) as Record<string, unknown>)
      .then(
        (document) => {
          if (!wanted) return;
          setFields((before) => withDatasheet(before, document));
          setKnown(address);
        },
        (error: unknown) => wanted && notifyOfError(error, t("ui-the-datasheet-was-not-read")),
      );
    return () => {
      wanted = false;
    };
  }, [address]);
  const barred = useOnlyViews();
  const armRow = arms.find(({ file }) => file === arm);
  const numbers = known === address && !barred ? numbersOf(fields) : null;
  const given = givenSizes(sizes);
  const asked = numbers &&
    given && { ...numbers, ...given, arm: armRow?.file ?? "", arm_version: armRow?.version ?? "" };
  const found = useBlockDesign(asked);
  const { design } = found;
  const document: Record<string, unknown> = design
    ? { ...(JSON.parse(design.document) as object), name: name.trim() }
    : {};
  const drawing = (file: BlockFile) => () => getBlockFile(design?.id ?? "", file, name.trim(), currentLanguage());
  const options = (some: DatasheetRow[], other: string) => [
    { value: "", label: other },
    ...some.map(({ file, name: called, serial_number }) => ({
      value: file,
      label: [called || file, serial_number].filter(Boolean).join(", "),
    })),
  ];
  return (
    <DesignPage
      title={t("ui-design-a-block")}
      text={t("ui-what-the-design-of-a-block-is")}
      picture={<BlockResult {...found} isWanted={asked !== null} barred={barred} />}
      files={[
        { label: "PDF", name: "block.pdf", make: drawing("block.pdf") },
        { label: "DXF", name: "block.dxf", make: drawing("block.dxf"), whyNot: design?.dxf_why_not ?? "" },
        { label: "STL", name: "block.stl", make: drawing("block.stl") },
        { label: "STEP", name: "block.step", make: drawing("block.step") },
        { label: "JSON", name: "object.json", make: () => jsonFile(JSON.stringify(document, null, 1)) },
      ]}
      ready={found.isCurrent && name.trim() !== ""}
      why={name.trim() && asked ? (found.problem?.detail ?? t("ui-no-block-yet")) : t("ui-correct-what-is-marked")}
      onTake={() => onTake(document)}
      onBack={onBack}
    >
      <Choice
        label={t("ui-sensor")}
        value={sensor}
        options={options(sensors, t("ui-without-a-datasheet"))}
        onChange={setSensor}
      />
      {!sensor && (
        <>
          <div className={styles.pair}>
            {(["width_px", "height_px"] as const).map((key) => (
              <TextField
                key={key}
                label={t(key === "width_px" ? "ui-width-in-pixels" : "ui-height-in-pixels")}
                inputMode="numeric"
                value={fields[key]}
                aria-invalid={!(Number(fields[key]) >= 1) || undefined}
                onText={(text) => setFields({ ...fields, [key]: text.replace(/\D/g, "").slice(0, 5) })}
              />
            ))}
          </div>
          <Choice
            label={t("ui-how-does-the-laser-line-run")}
            value={fields.stripe_axis}
            options={[
              { value: "u", label: t("ui-from-left-to-right") },
              { value: "v", label: t("ui-from-top-to-bottom") },
            ]}
            onChange={(axis) => setFields({ ...fields, stripe_axis: axis === "v" ? "v" : "u" })}
          />
        </>
      )}
      {SLIDER_NAMES.map((key) => {
        const { label, ...range } = SLIDERS[key];
        return (
          <NumberSlider
            key={key}
            {...range}
            label={t(label)}
            value={fields[key]}
            onText={(text) => setFields({ ...fields, [key]: text })}
          />
        );
      })}
      <BlockSizes fields={sizes} proposed={design ? sizesOf(document) : NO_SIZES} onFields={setSizes} />
      <Choice label={t("ui-arm")} value={arm} options={options(arms, t("ui-a-usual-arm"))} onChange={setArm} />
      <TextField
        label={t("ui-name-of-the-block")}
        maxLength={120}
        value={name}
        aria-invalid={name.trim() === "" || undefined}
        onText={setName}
      />
    </DesignPage>
  );
}
