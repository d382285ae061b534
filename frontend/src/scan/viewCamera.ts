/** The part of the 3D view's page that is used here: its camera, whose y is up; in metres. */
interface Controls {
  maxPolarAngle: number;
  distance: number;
  dollyTo(distance: number, transition: boolean): void;
  getTarget(into: Point): Point;
  moveTo(x: number, y: number, z: number, transition: boolean): void;
  addEventListener(kind: "update", listener: () => void): void;
  camera: { position: Point };
}
type Point = { x: number; y: number; z: number; clone(): Point };

type Viser = {
  __viserMutable?: { cameraControl?: Controls | null };
  __viserSceneTree?: { getState(): Record<string, unknown> };
};

/** The camera of the 3D view in a frame; null before it is drawn. */
export function controlsOf(frame: Window | null): Controls | null {
  return (frame as (Window & Viser) | null)?.__viserMutable?.cameraControl ?? null;
}

/** Whether the station's scene is there: the table comes first. */
export function hasScene(frame: Window): boolean {
  return (frame as Window & Viser).__viserSceneTree?.getState()["/table"] !== undefined;
}

/** The camera looks from above only, and at nothing below the table, whose height is given in mm. */
export function keepAboveTable(controls: Controls, floor_mm: () => number): void {
  controls.maxPolarAngle = Math.PI / 2;
  const target = controls.camera.position.clone();
  controls.addEventListener("update", () => {
    controls.getTarget(target);
    const floor = floor_mm() / 1000;
    if (target.y < floor - 1e-6) controls.moveTo(target.x, floor, target.z, false);
  });
}

/** Keeps what is seen from left to right when the picture becomes narrower or wider by a factor. */
export function keepWidth(controls: Controls, factor: number): void {
  controls.dollyTo(controls.distance / factor, false);
}
