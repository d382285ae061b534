import type { BoardGeometry } from "../api/wire";
import styles from "./BoardDrawing.module.css";
import { BOARD_FACE, blackSquares, narrowSides, printedSide } from "./board";
import { pathOf, type View } from "./view";

interface BoardDrawingProps {
  board: BoardGeometry;
  view: View;
  /** Highlighted. */
  face: string | null;
  onFace: ((face: string) => void) | undefined;
}

/** A thin plate with the pattern on its printed side. */
export function BoardDrawing({ board, view, face, onFace }: BoardDrawingProps) {
  return (
    <>
      {narrowSides(board, view.to).map(({ side, outline }) => (
        <path key={side} d={pathOf(view, outline)} className={styles.side} data-side={side} />
      ))}
      <g
        className={styles.printed}
        data-face={BOARD_FACE}
        data-chosen={face === BOARD_FACE || undefined}
        data-pressable={onFace ? true : undefined}
        onClick={onFace && (() => onFace(BOARD_FACE))}
      >
        <path d={pathOf(view, printedSide(board))} className={styles.board} />
        <path
          d={blackSquares(board)
            .map((square) => pathOf(view, square))
            .join("")}
          className={styles.black}
        />
      </g>
    </>
  );
}
