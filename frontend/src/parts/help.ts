import { words } from "../state/language";

/** What helps in a step beyond its one sentence: a few lines each, shown when asked for. */
export const HELP: Readonly<Record<string, readonly string[]>> = {
  "flow/devices": [
    words("Arm and sensor are found by themselves. What is missing says why, and comes back by itself."),
    words("Reload the page or take another tablet at any time: nothing is lost."),
  ],
  "flow/setup": [
    words("Choose the papers of what is clamped and mounted: the result is only as true as they are."),
    words("A wrong tip or another object shows in the residuals later, and is said then."),
  ],
  "flow/touch": [
    words("Clamp the object so that it cannot move before the last picture is taken."),
    words("The arm's main button takes a point. Undo takes it back; undo held goes a step back."),
    words("Spread the points wide over each face, clear of its edges. Tap a point in the drawing to see it and take it out."),
  ],
  "flow/place": [
    words("Hold the sensor so that the object fills the picture and the laser's line crosses it."),
    words("The arm's main button goes on; undo held goes a step back."),
  ],
  "flow/capture": [
    words("The picture is taken only while the arm is still. There is no hurry."),
    words("The arm's main button takes it; undo held goes a step back."),
  ],
  "flow/solve": [
    words("Poses that are tilted or turned another way make the result better. The one that helps most is named."),
    words("The arm's main button does what the large button here says."),
  ],
  "flow/review": [
    words("k = 1: about two of three points lie within. k = 2: about nineteen of twenty."),
    words("Look where the worst points are. A pose can be set aside, and taken back."),
    words("Nothing is in use before you accept it."),
  ],
  "verify/gauge": [
    words("Use a gauge with a paper: its size, form and uncertainty go into the verdict."),
    words("Clamp it. It must not move between the touches and the last cloud."),
  ],
  "verify/touch": [
    words("The arm's main button takes a touch. Undo takes it back; undo held goes a step back."),
    words("Without touches only shape, size and spread are judged, not the place."),
  ],
  "verify/scan": [
    words("The arm's main button begins and ends a cloud. Undo sets the last one aside; undo held goes a step back."),
    words("Pass slowly and evenly, and keep the distance sign green."),
  ],
  "verify/review": [
    words("Pass: the error and its uncertainty (k = 2) keep the limit. Fail: both are beyond it. Between the two nothing is decided (ISO 14253-1)."),
  ],
  "arm/seat": [
    words("A seat is a cone or three balls that the tip settles into and turns in without play."),
    words("The arm's main button begins."),
  ],
  "arm/swing": [
    words("Keep the tip settled and turn every joint as far as it goes, slowly. Points are taken by themselves."),
    words("The arm's main button ends it."),
  ],
  "arm/touch": [words("Hold still at each place; the arm's main button takes it.")],
  scan: [
    words("Keep the distance sign green. Where it says too fast, go slower: the line is smeared."),
    words("Pass over a place again to fill it. What was scanned is recorded at once, and kept whatever happens."),
  ],
};
