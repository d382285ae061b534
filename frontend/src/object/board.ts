import type { Vec3 } from "../api/types";
import type { BoardGeometry } from "../api/wire";

/** In squares: width of the white border around the pattern, and thickness of the plate. */
const RIM = 1;
const THICKNESS = 0.3;

export const BOARD_FACE = "board";

interface Range {
  low: number;
  high: number;
}

/** The plate from edge to edge: the squares around the inner corners, and the rim around those. */
function extent({ inner_corners, square_mm }: BoardGeometry): { x: Range; y: Range } {
  const [columns, rows] = inner_corners;
  const low = -(1 + RIM) * square_mm;
  return {
    x: { low, high: (columns + RIM) * square_mm },
    y: { low, high: (rows + RIM) * square_mm },
  };
}

function rectangle(x: Range, y: Range, z: number): Vec3[] {
  return [
    [x.low, y.low, z],
    [x.high, y.low, z],
    [x.high, y.high, z],
    [x.low, y.high, z],
  ];
}

function back_mm(board: BoardGeometry): number {
  return -THICKNESS * board.square_mm;
}

/** The printed side, with the white border around the pattern. */
export function printedSide(board: BoardGeometry): Vec3[] {
  const { x, y } = extent(board);
  return rectangle(x, y, 0);
}

/** The black squares. */
export function blackSquares({ inner_corners, square_mm, first_is_black }: BoardGeometry): Vec3[][] {
  const [columns, rows] = inner_corners;
  const squares: Vec3[][] = [];
  for (let j = -1; j < rows; j++) {
    for (let i = -1; i < columns; i++) {
      if (((i + j) % 2 === 0) !== first_is_black) continue;
      const x = { low: i * square_mm, high: (i + 1) * square_mm };
      const y = { low: j * square_mm, high: (j + 1) * square_mm };
      squares.push(rectangle(x, y, 0));
    }
  }
  return squares;
}

/** The plate's two narrow sides that look at a viewer towards `to`, who stands before the board. */
export function narrowSides(board: BoardGeometry, to: Vec3): { side: "front" | "end"; outline: Vec3[] }[] {
  const { x, y } = extent(board);
  const back = back_mm(board);
  const end = to[0] < 0 ? x.low : x.high;
  const front = to[1] < 0 ? y.low : y.high;
  return [
    {
      side: "end",
      outline: [
        [end, y.low, 0],
        [end, y.high, 0],
        [end, y.high, back],
        [end, y.low, back],
      ],
    },
    {
      side: "front",
      outline: [
        [x.low, front, 0],
        [x.high, front, 0],
        [x.high, front, back],
        [x.low, front, back],
      ],
    },
  ];
}

/** The shadow of the board: its outline, slightly enlarged. */
export function boardFootprint(board: BoardGeometry): Vec3[] {
  const { x, y } = extent(board);
  const wider = ({ low, high }: Range): Range => ({ low: low - 0.03 * (high - low), high: high + 0.03 * (high - low) });
  return rectangle(wider(x), wider(y), back_mm(board));
}

export function boardMiddle(board: BoardGeometry): Vec3 {
  const { x, y } = extent(board);
  return [(x.low + x.high) / 2, (y.low + y.high) / 2, back_mm(board) / 2];
}

/** Half the board's width, height and thickness. */
export function boardHalfSize(board: BoardGeometry): Vec3 {
  const { x, y } = extent(board);
  return [(x.high - x.low) / 2, (y.high - y.low) / 2, -back_mm(board) / 2];
}
