import { type DragEvent, useEffect, useState } from "react";

import { getCertificatePage } from "../api/certificateCommands";
import { notifyOfError } from "../api/commands";
import { fileOf } from "../api/datasheetCommands";
import { getFile } from "../api/http";
import type { BlockGeometry, DatasheetRow, MeasuredBlock, Problem } from "../api/wire";
import { fromTyped } from "../controls/lengths";
import { Segments } from "../controls/Segments";
import { TextField } from "../controls/TextField";
import forms from "../datasheets/Datasheets.module.css";
import { drawn } from "../datasheets/drawn";
import design from "../design/Design.module.css";
import { jsonFile } from "../design/DesignFiles";
import { DesignPage } from "../design/DesignPage";
import { ObjectDrawing } from "../object/ObjectDrawing";
import { useOnlyViews } from "../state/control";
import { currentLanguage, t } from "../state/language";
import { CertificateResult } from "./CertificateResult";
import styles from "./Certify.module.css";
import { DimensionLine } from "./DimensionLine";
import { type Dimension, dimensionsOf, readingsTable } from "./dimensions";
import { type Draft, useDraft } from "./draft";
import { ReadingFields } from "./ReadingFields";
import { areJointAngles, readTable, TableFiles } from "./TableFiles";
import { useCertificate } from "./useCertificate";

/** The readings do not reach every face yet: nothing is wrong. */
const INCOMPLETE = "readings-incomplete";

interface BlockCertifierProps {
  row: DatasheetRow;
  arms: DatasheetRow[];
  onSave: (document: string) => Promise<boolean>;
  onBack: () => void;
}

/** The certificate of a block by what was measured of it: its readings, its faces, its files. */
export function BlockCertifier({ row, arms, onSave, onBack }: BlockCertifierProps) {
  const block = useBlock(row);
  const connected = arms.find((one) => one.connected)?.file ?? "";
  const { draft, change, forget } = useDraft(`${row.file} ${row.version}`, connected);
  const [dimension, setDimension] = useState<Dimension | null>(null);
  const [over, setOver] = useState(false);
  const barred = useOnlyViews();
  const asked = block && !barred ? measuredBlock(row, arms, draft, block.edges_x_mm.length) : null;
  const { made, problem } = useCertificate(asked);
  const takeFiles = async (files: FileList) => {
    const taken = await Promise.all(Array.from(files).map(readTable));
    change(Object.assign({}, ...taken) as Partial<Draft>);
  };
  const drop = (event: DragEvent) => {
    event.preventDefault();
    setOver(false);
    void takeFiles(event.dataTransfer.files);
  };
  const drag = (event: DragEvent) => {
    if (!event.dataTransfer.types.includes("Files")) return;
    event.preventDefault();
    setOver(true);
  };
  return (
    <DesignPage
      title={t("ui-certify-a-block")}
      text={t("ui-what-certifying-is", { name: row.name || row.file })}
      files={[
        {
          label: "PDF",
          name: "block-certificate.pdf",
          make: () => getCertificatePage(asked as MeasuredBlock, currentLanguage()),
        },
        { label: "JSON", name: "object.json", make: () => jsonFile(made?.document ?? "") },
      ]}
      ready={made !== null}
      why={why(asked, problem, isTyped(draft))}
      take={t("ui-store-the-certificate")}
      onTake={async () => {
        if (made && (await onSave(made.document))) forget();
      }}
      onBack={onBack}
      picture={
        <div
          className={styles.picture}
          data-over={over || undefined}
          data-drop
          onDragOver={drag}
          onDragLeave={() => setOver(false)}
          onDrop={drop}
        >
          <div className={design.state}>
            {barred && <p className={design.refused}>{barred}</p>}
            {problem && (
              <p className={problem.code === INCOMPLETE ? design.missing : design.refused} role="status">
                {problem.detail} {problem.remedy}
              </p>
            )}
          </div>
          {block && (
            <div className={forms.drawing}>
              <BlockWithDimension block={block} dimension={dimension} />
            </div>
          )}
          {made && <CertificateResult made={made} />}
        </div>
      }
    >
      {draft.table === null && (
        <Segments
          wide
          label={t("ui-measured-with")}
          value={draft.instrument}
          options={[
            { value: "calliper", label: t("ui-calliper") },
            { value: "micrometer", label: t("ui-micrometer") },
            { value: "none", label: t("ui-points-alone") },
          ]}
          onChange={(instrument) => {
            change({ instrument: instrument as Draft["instrument"] });
            setDimension(null);
          }}
        />
      )}
      {block && dimension && (
        <div className={styles.follow}>
          <BlockWithDimension block={block} dimension={dimension} />
        </div>
      )}
      {block && draft.table === null && draft.instrument !== "none" && (
        <ReadingFields
          instrument={draft.instrument}
          edges={block.edges_x_mm.length}
          draft={draft}
          onChange={change}
          onDimension={setDimension}
        />
      )}
      <TableFiles arms={arms} draft={draft} onChange={change} onFiles={takeFiles} />
      <TextField
        label={t("ui-certified-by")}
        help={t("ui-certified-by-help")}
        maxLength={200}
        value={draft.certificate}
        onText={(certificate) => change({ certificate })}
      />
    </DesignPage>
  );
}

function BlockWithDimension({ block, dimension }: { block: BlockGeometry; dimension: Dimension | null }) {
  return (
    <ObjectDrawing object={block} face={null} label={t("ui-block-with-dimension")}>
      {(view) => dimension && <DimensionLine block={block} dimension={dimension} view={view} />}
    </ObjectDrawing>
  );
}

/** Why there is nothing to store yet; what the station refuses stands beside the drawing. */
function why(asked: MeasuredBlock | null, problem: Problem | null, typed: boolean): string {
  if (!asked) return t(typed ? "ui-correct-what-is-marked" : "ui-enter-readings-or-points");
  if (!problem) return t("ui-being-checked");
  return problem.code === INCOMPLETE ? t("ui-some-faces-are-not-reached") : t("ui-correct-what-is-said");
}

const isTyped = ({ instrument, table, readings, points }: Draft) =>
  points !== null || table !== null || (instrument !== "none" && Object.values(readings).some((one) => one.trim()));

/** What the station is asked; null while nothing is entered, or something is no number. */
function measuredBlock(row: DatasheetRow, arms: DatasheetRow[], draft: Draft, edges: number): MeasuredBlock | null {
  const { instrument, points, table } = draft;
  let readings: string | null = table?.text ?? "";
  if (!table && instrument !== "none") {
    const dimensions = dimensionsOf(edges, instrument);
    readings = readingsTable(dimensions, draft.readings, instrument, draft.numbers[instrument]);
  }
  if (readings === null || !(readings || points)) return null;
  const arm = points && areJointAngles(points.text) ? arms.find(({ file }) => file === draft.arm) : undefined;
  const um = (text: string) => (arm && text.trim() ? fromTyped(text, "µm") : null);
  const [arm_um, tip_um] = [um(draft.arm_um), um(draft.tip_um)];
  if (Number.isNaN(arm_um) || Number.isNaN(tip_um)) return null;
  return {
    file: row.file,
    version: row.version,
    readings,
    points: points?.text ?? "",
    certificate: draft.certificate.trim(),
    arm: arm?.file ?? "",
    arm_version: arm?.version ?? "",
    arm_um,
    tip_um,
  };
}

/** The block as its datasheet says; null until it is read. */
function useBlock(row: DatasheetRow): BlockGeometry | null {
  const [block, setBlock] = useState<BlockGeometry | null>(null);
  const address = fileOf(row);
  useEffect(() => {
    let wanted = true;
    getFile(address)
      .then(async (file) => drawn("block", JSON.parse(await file.text()) as Record<string, unknown>))
      .then(
        (found) => wanted && found?.kind === "block" && setBlock(found),
        (error: unknown) => wanted && notifyOfError(error, t("ui-the-datasheet-was-not-read")),
      );
    return () => {
      wanted = false;
    };
  }, [address]);
  return block;
}
