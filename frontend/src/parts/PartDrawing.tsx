import type { FeatureMark, PartView } from "../api/wire";
import { t } from "../state/language";
import styles from "./PartDrawing.module.css";
import { type Flat, frameAbout, middleOf, type Point, project } from "./projection";

const MARGIN = 0.06;

/** The features of the program as its drawing has them, the one to touch next marked, and the
 *  touches of the feature in hand. */
export function PartDrawing({ view }: { view: PartView }) {
  const features = view.features.map((mark) => ({ mark, lines: mark.lines.map(flatten) }));
  const frame = frameAbout(
    features.flatMap(({ lines }) => lines.flat()),
    MARGIN,
  );
  const scale = Math.max(frame.width, frame.height) / 100;
  return (
    <svg
      className={styles.drawing}
      viewBox={`${frame.left} ${frame.top} ${frame.width} ${frame.height}`}
      role="img"
      aria-label={t("ui-part-drawing")}
    >
      {features.map(({ mark, lines }) => (
        <Feature key={mark.id} mark={mark} lines={lines} />
      ))}
      {features.map(({ mark, lines }) => {
        const [x, y] = middleOf(lines.flat());
        return (
          <text key={mark.id} className={styles.name} x={x} y={y + 1.1 * scale} fontSize={3.2 * scale}>
            {mark.id}
          </text>
        );
      })}
      {view.touches.map(({ number, at_mm }) => {
        if (at_mm === null) return null;
        const [x, y] = project(at_mm as unknown as Point);
        return <circle key={number} className={styles.touch} cx={x} cy={y} r={0.7 * scale} />;
      })}
    </svg>
  );
}

function flatten(line: readonly (readonly number[])[]): Flat[] {
  return line.map((point) => project(point as unknown as Point));
}

interface FeatureProps {
  mark: FeatureMark;
  lines: Flat[][];
}

function Feature({ mark, lines }: FeatureProps) {
  return (
    <g
      className={styles.feature}
      data-state={mark.state}
      data-next={mark.is_next || undefined}
      data-outcome={mark.outcome}
    >
      {lines.map((line, i) => (
        <polyline key={i} points={line.map((point) => point.join(",")).join(" ")} data-closed={isClosed(line)} />
      ))}
    </g>
  );
}

function isClosed(line: Flat[]): boolean {
  const [first, last] = [line[0], line[line.length - 1]];
  return first !== undefined && last !== undefined && Math.hypot(first[0] - last[0], first[1] - last[1]) < 0.05;
}
