import { useEffect, useState } from "react";

import { designBoard, getBoardPage } from "../api/designCommands";
import { Refused } from "../api/http";
import type { BoardDesignView, Problem } from "../api/wire";
import fieldLook from "../controls/Field.module.css";
import { isLength, LengthField } from "../controls/LengthField";
import { fromTyped, measured, roundTyped } from "../controls/lengths";
import { Segments } from "../controls/Segments";
import { TextField } from "../controls/TextField";
import { useSettled } from "../controls/useSettled";
import forms from "../datasheets/Datasheets.module.css";
import { drawn } from "../datasheets/drawn";
import { ObjectDrawing } from "../object/ObjectDrawing";
import { useOnlyViews } from "../state/control";
import { currentLanguage, t } from "../state/language";
import { Choice } from "./Choice";
import styles from "./Design.module.css";
import { jsonFile } from "./DesignFiles";
import { DesignPage } from "./DesignPage";

type Kind = "charuco" | "chessboard";

const PAGES = ["A4", "A3", "A2", "A1", "A0", "letter", "legal", "tabloid"] as const;

interface BoardDesignerProps {
  onTake: (kind: Kind, document: Record<string, unknown>) => void;
  onBack: () => void;
}

interface Answer {
  asked: string;
  board: BoardDesignView | null;
  problem: Problem | null;
}

/** A board to print, to scale; and its datasheet once two lengths of the print are measured. */
export function BoardDesigner({ onTake, onBack }: BoardDesignerProps) {
  const [kind, setKind] = useState<Kind>("charuco");
  const [counts, setCounts] = useState({ columns: "11", rows: "8" });
  const [square, setSquare] = useState(() => roundTyped(20, "mm", 4));
  const [firstId, setFirstId] = useState("0");
  const [page, setPage] = useState("");
  const [name, setName] = useState<string | null>(null);
  const [printed, setPrinted] = useState({ measured_x_mm: "", measured_y_mm: "" });
  const title = t(kind === "charuco" ? "ui-charuco-board" : "ui-chessboard");
  const called = name ?? `${title} ${counts.columns} × ${counts.rows}`;
  const barred = useOnlyViews();
  const plain = barred ? null : boardOf(kind, counts, square, called, printed);
  const board = plain && kind === "charuco" ? withFirstId(plain, firstId) : plain;
  const asked = board && page ? { ...board, page } : board;
  const { answer, last } = useBoard(asked ? JSON.stringify(asked) : "");
  const isCurrent = answer?.board != null;
  const document = last ? (JSON.parse(last.document) as Record<string, unknown>) : {};
  const drawing = last && drawn("squares_x" in document ? "charuco" : "chessboard", document);
  return (
    <DesignPage
      title={t("ui-print-a-board")}
      text={t("ui-what-a-printed-board-is")}
      files={[
        { label: "PDF", name: "board.pdf", make: () => getBoardPage(asked ?? {}, currentLanguage()) },
        { label: "JSON", name: "object.json", make: () => jsonFile(last?.document ?? "") },
      ]}
      ready={isCurrent}
      why={asked ? (answer?.problem?.detail ?? t("ui-no-board-to-take")) : t("ui-correct-what-is-marked")}
      onTake={() => onTake(kind, document)}
      onBack={onBack}
      picture={
        <>
          <div className={styles.state}>
            {barred && <p className={styles.refused}>{barred}</p>}
            {answer?.problem && (
              <p className={styles.refused} role="alert">
                {answer.problem.detail} {answer.problem.remedy}
              </p>
            )}
          </div>
          {last && drawing ? (
            <>
              <div className={forms.drawing} data-stale={!isCurrent || undefined}>
                <ObjectDrawing object={drawing} face={null} label={t("ui-board-to-print")} />
              </div>
              <div className={styles.results} data-stale={!isCurrent || undefined}>
                <p>
                  {t("ui-pattern-and-page", {
                    width: size(last.width_mm),
                    height: size(last.height_mm),
                    page: last.page,
                  })}
                </p>
              </div>
            </>
          ) : (
            <p className={forms.none}>{t("ui-drawing-follows-the-numbers")}</p>
          )}
        </>
      }
    >
      <Segments
        wide
        label={t("ui-kind-of-board")}
        value={kind}
        options={[
          { value: "charuco", label: t("ui-charuco-board") },
          { value: "chessboard", label: t("ui-chessboard") },
        ]}
        onChange={(chosen) => setKind(chosen === "chessboard" ? "chessboard" : "charuco")}
      />
      <div className={styles.pair}>
        {(["columns", "rows"] as const).map((key) => (
          <TextField
            key={key}
            label={t(key === "columns" ? "ui-squares-across" : "ui-squares-down")}
            inputMode="numeric"
            value={counts[key]}
            aria-invalid={!isCount(counts[key]) || undefined}
            onText={(text) => setCounts({ ...counts, [key]: text.replace(/\D/g, "").slice(0, 3) })}
          />
        ))}
      </div>
      <LengthField label={t("ui-side-of-a-square")} value={square} needed onText={setSquare} />
      {kind === "charuco" && (
        <TextField
          label={t("ui-id-of-the-first-marker")}
          inputMode="numeric"
          value={firstId}
          aria-invalid={firstId === "" || undefined}
          onText={(text) => setFirstId(text.replace(/\D/g, "").slice(0, 3))}
        />
      )}
      <Choice
        label={t("ui-page-to-print-on")}
        value={page}
        options={[
          { value: "", label: t("ui-smallest-page") },
          ...PAGES.map((one) => ({ value: one, label: one[0]?.toUpperCase() + one.slice(1) })),
        ]}
        onChange={setPage}
      />
      <TextField
        label={t("ui-name-of-the-board")}
        maxLength={120}
        value={called}
        aria-invalid={called.trim() === "" || undefined}
        onText={setName}
      />
      <p className={fieldLook.help}>{t("ui-measure-the-print")}</p>
      <div className={styles.pair}>
        {(["measured_x_mm", "measured_y_mm"] as const).map((key) => (
          <LengthField
            key={key}
            label={t(key === "measured_x_mm" ? "ui-measured-width" : "ui-measured-height")}
            value={printed[key]}
            needed={Object.values(printed).some(Boolean)}
            onText={(text) => setPrinted({ ...printed, [key]: text })}
          />
        ))}
      </div>
    </DesignPage>
  );
}

const size = (mm: number) => measured(mm, "mm", Number.isInteger(mm) ? 0 : 2);

const isCount = (text: string) => Number(text) >= 1;

/** Boards of a set count on where the one before ends. */
const withFirstId = (board: Record<string, string>, first: string) =>
  first === "" ? null : { ...board, first_id: first };

/** The fields of the station's address; null while they hold nothing that it takes. */
function boardOf(
  kind: Kind,
  counts: Record<"columns" | "rows", string>,
  square: string,
  name: string,
  printed: Record<"measured_x_mm" | "measured_y_mm", string>,
): Record<string, string> | null {
  const square_mm = fromTyped(square, "mm");
  if (!Object.values(counts).every(isCount) || !(isLength(square) && square_mm >= 0.2) || !name.trim()) return null;
  const board = { kind, ...counts, square_mm: String(square_mm), name: name.trim() };
  if (!Object.values(printed).some(Boolean)) return board;
  const lengths = Object.entries(printed).map(([key, text]) => [key, fromTyped(text, "mm")] as const);
  if (!lengths.every(([key, length]) => isLength(printed[key as keyof typeof printed]) && length >= 1)) return null;
  return { ...board, ...Object.fromEntries(lengths.map(([key, length]) => [key, String(length)])) };
}

/** What the station makes of a board once the fields rest: for these fields, and the last one that it made. */
function useBoard(text: string) {
  const settled = useSettled(text);
  const [answer, setAnswer] = useState<Answer | null>(null);
  const [last, setLast] = useState<BoardDesignView | null>(null);
  useEffect(() => {
    if (!settled) return;
    let wanted = true;
    designBoard(JSON.parse(settled) as Record<string, string>).then(
      (board) => {
        if (!wanted) return;
        setAnswer({ asked: settled, board, problem: null });
        setLast(board);
      },
      (error: unknown) => {
        // the lost connection has its own banner
        if (wanted && error instanceof Refused) setAnswer({ asked: settled, board: null, problem: error.problem });
      },
    );
    return () => {
      wanted = false;
    };
  }, [settled]);
  return { answer: answer?.asked === text ? answer : null, last };
}
