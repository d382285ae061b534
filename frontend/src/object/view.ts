import type { ObjectGeometry, Vec3 } from "../api/types";
import { BOARD_FACE } from "./board";
import { halfSize, middle } from "./shape";
import { dot } from "./vector";

/** Direction of the viewer: azimuth from the front (0) to the right (90), and elevation. */
export interface Heading {
  azimuth_deg: number;
  elevation_deg: number;
}

interface Headings {
  resting: Heading;
  /** The direction from which each face is best visible. */
  faces: Record<string, Heading>;
}

const HEADINGS: Record<ObjectGeometry["kind"], Headings> = {
  block: {
    resting: { azimuth_deg: 24, elevation_deg: 34 },
    faces: {
      crest: { azimuth_deg: 18, elevation_deg: 46 },
      floor: { azimuth_deg: 10, elevation_deg: 58 },
      front: { azimuth_deg: 20, elevation_deg: 26 },
      back: { azimuth_deg: 160, elevation_deg: 26 },
      left: { azimuth_deg: -58, elevation_deg: 26 },
      right: { azimuth_deg: 58, elevation_deg: 26 },
    },
  },
  board: {
    resting: { azimuth_deg: 24, elevation_deg: 44 },
    faces: { [BOARD_FACE]: { azimuth_deg: 16, elevation_deg: 58 } },
  },
};

/** The direction from which a face is best visible, along the shorter rotation from the current view. */
export function headingFor({ kind }: ObjectGeometry, face: string | null): Heading {
  const { resting, faces } = HEADINGS[kind];
  return (face && faces[face]) || resting;
}

/** The radius of a touched point's dot, in px: smaller where the object is small. */
export function dotRadius(view: View): number {
  return Math.min(9, Math.max(5, view.scale * 0.8));
}

export interface View {
  /** Unit vectors in the object frame: to the viewer, right and up on the screen. */
  to: Vec3;
  right: Vec3;
  up: Vec3;
  scale: number;
  centre: Vec3;
  width: number;
  height: number;
}

/** Margin around the object, as a share of the smaller side of the picture. */
const MARGIN = 0.06;

/** Half the width and height of the object on the screen, in mm, at a heading. */
function reach(half: Vec3, { azimuth_deg, elevation_deg }: Heading): [number, number] {
  const azimuth = (azimuth_deg * Math.PI) / 180;
  const elevation = (elevation_deg * Math.PI) / 180;
  const [x, y, z] = half;
  const across = x * Math.abs(Math.cos(azimuth)) + y * Math.abs(Math.sin(azimuth));
  const deep = x * Math.abs(Math.sin(azimuth)) + y * Math.abs(Math.cos(azimuth));
  return [across, deep * Math.sin(elevation) + z * Math.cos(elevation)];
}

/** The scale at which every heading fits, so that turning does not zoom. */
function fittingScale(object: ObjectGeometry, width: number, height: number): number {
  const margin = MARGIN * Math.min(width, height);
  const { resting, faces } = HEADINGS[object.kind];
  const reaches = [resting, ...Object.values(faces)].map((heading) => reach(halfSize(object), heading));
  const across = Math.max(...reaches.map(([x]) => x));
  const up = Math.max(...reaches.map(([, y]) => y));
  return Math.max(0.5, Math.min((width / 2 - margin) / across, (height / 2 - margin) / up));
}

/** The unit vectors of a viewer at a heading. */
export function lookFrom(heading: Heading): Pick<View, "to" | "right" | "up"> {
  const azimuth = (heading.azimuth_deg * Math.PI) / 180;
  const elevation = (heading.elevation_deg * Math.PI) / 180;
  const flat = Math.cos(elevation);
  return {
    to: [Math.sin(azimuth) * flat, -Math.cos(azimuth) * flat, Math.sin(elevation)],
    right: [Math.cos(azimuth), Math.sin(azimuth), 0],
    up: [-Math.sin(azimuth) * Math.sin(elevation), Math.cos(azimuth) * Math.sin(elevation), flat],
  };
}

/** Parallel projection in which the object has the same size at every heading. */
export function makeView(object: ObjectGeometry, heading: Heading, width: number, height: number): View {
  const scale = fittingScale(object, width, height);
  return { ...lookFrom(heading), scale, centre: middle(object), width, height };
}

/** A point of the object frame on the screen, in px. */
export function project(view: View, at: Vec3): [number, number] {
  const from: Vec3 = [at[0] - view.centre[0], at[1] - view.centre[1], at[2] - view.centre[2]];
  return [view.width / 2 + dot(view.right, from) * view.scale, view.height / 2 - dot(view.up, from) * view.scale];
}

export function pathOf(view: View, outline: Vec3[]): string {
  const points = outline.map((at) =>
    project(view, at)
      .map((px) => px.toFixed(2))
      .join(" "),
  );
  return `M${points.join("L")}Z`;
}

/** An SVG matrix that projects a flat drawing in mm onto the face with this normal. */
export function layOn(view: View, at: Vec3, normal: Vec3): string {
  const [a, b]: [Vec3, Vec3] =
    normal[2] !== 0
      ? [
          [1, 0, 0],
          [0, 1, 0],
        ]
      : normal[1] !== 0
        ? [
            [1, 0, 0],
            [0, 0, 1],
          ]
        : [
            [0, 1, 0],
            [0, 0, 1],
          ];
  const [x, y] = project(view, at);
  const column = (axis: Vec3) => `${dot(view.right, axis) * view.scale} ${-dot(view.up, axis) * view.scale}`;
  return `matrix(${column(a)} ${column(b)} ${x} ${y})`;
}
