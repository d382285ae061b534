import type { ObjectGeometry, Vec3 } from "../api/types";
import type { BlockGeometry, BoardGeometry } from "../api/wire";
import { t } from "../state/language";
import { isVisible } from "./block";
import styles from "./Illustration.module.css";
import { ObjectDrawing } from "./ObjectDrawing";
import { pathOf, project, type View } from "./view";

/** A generic block for pages without a certificate. */
const ANY_BLOCK: BlockGeometry = {
  kind: "block",
  edges_x_mm: [-24, -15, -7, -1, 6, 12, 19, 24],
  front_y_mm: -13,
  back_y_mm: 13,
  crest_z_mm: 15,
  floor_z_mm: 0,
  base_z_mm: -12,
};

/** The same of a board, and where the stripe crosses its printed side. */
const ANY_BOARD: BoardGeometry = { kind: "board", inner_corners: [7, 6], square_mm: 5, first_is_black: true };
const BOARD_STRIPE: Vec3[] = [
  [-10, 13, 0],
  [40, 13, 0],
];

const UP: Vec3 = [0, 0, 1];
const STEP_MM = 0.5;
const STRIPE_Y_MM = -7;

/** Illustration of a calibration by pictures alone: a chessboard, and the laser stripe across it. */
export function BoardIllustration() {
  const label = t("ui-chessboard-laser-stripe-across");
  return <Crossed object={ANY_BOARD} label={label} stripe={(view) => pathOf(view, BOARD_STRIPE)} />;
}

/** Illustration of a calibration: the object, and the laser stripe across crests and floors. */
export function Illustration() {
  const label = t("ui-crenellated-object-laser-stripe-across");
  return <Crossed object={ANY_BLOCK} label={label} stripe={(view) => stripePath(view, ANY_BLOCK)} />;
}

interface CrossedProps {
  object: ObjectGeometry;
  label: string;
  stripe: (view: View) => string;
}

/** An object that the laser stripe crosses. */
function Crossed({ object, label, stripe }: CrossedProps) {
  return (
    <div className={styles.illustration}>
      <ObjectDrawing object={object} face={null} label={label}>
        {(view) => <path className={styles.stripe} d={stripe(view)} />}
      </ObjectDrawing>
    </div>
  );
}

function heightAt(block: BlockGeometry, x: number): number {
  const passed = block.edges_x_mm.filter((edge) => edge <= x).length;
  return passed % 2 === 1 ? block.crest_z_mm : block.floor_z_mm;
}

function stripePath(view: View, block: BlockGeometry): string {
  const first = block.edges_x_mm[0] ?? 0;
  const last = block.edges_x_mm[block.edges_x_mm.length - 1] ?? 0;
  let path = "";
  let drawnAt: number | null = null;
  for (let x = first + STEP_MM / 2; x < last; x += STEP_MM) {
    const z = heightAt(block, x);
    const at: Vec3 = [x, STRIPE_Y_MM, z];
    if (!isVisible(block, at, UP, view.to)) {
      drawnAt = null;
      continue;
    }
    path += `${drawnAt === z ? "L" : "M"}${project(view, at).join(" ")}`;
    drawnAt = z;
  }
  return path;
}
