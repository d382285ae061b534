import type { StandardMark } from "../../api/wire";
import type { PlainId } from "../../messages/text";
import { t } from "../../state/language";
import keys from "../session/MapKey.module.css";
import styles from "./LengthPlaces.module.css";
import { type Point, placeLabels } from "./placeLabels";

/** A point of the arm's frame on the drawing: to the right, and up. */
type Projection = (point: readonly [number, number, number]) => Point;

/** With more places than these only the present one has its number. */
const MOST_LABELS = 8;

/** Least distance of two numbers' middles, in hundredths of the reach. */
const LABEL_APART = 11;

/* Away from the arm is up in the one, and to the right in the other. */
const FROM_ABOVE: Projection = ([x, y]) => [-y, x];
const FROM_THE_SIDE: Projection = ([x, , z]) => [x, z];

interface LengthPlacesProps {
  reach_mm: number;
  shoulder_mm: number;
  places: StandardMark[];
  /** What a place is called that is done. */
  done?: PlainId;
  /** Whether nothing else is drawn beside it. */
  alone?: boolean;
}

/** The places of a standard or of seats within the arm's reach, from above and from the side. */
export function LengthPlaces({
  reach_mm: reach,
  shoulder_mm: shoulder,
  places,
  done = "ui-place-done",
  alone = false,
}: LengthPlacesProps) {
  const edge = 0.08 * reach;
  return (
    <figure className={styles.places}>
      <div className={styles.views} data-alone={alone || undefined}>
        <View
          title={t("ui-from-above-arm-below")}
          box={[-reach - edge, -0.35 * reach, 2 * (reach + edge), 1.35 * reach + edge]}
          centre={[0, 0]}
          reach={reach}
          places={places}
          project={FROM_ABOVE}
        />
        <View
          title={t("ui-from-the-side-arm-left")}
          box={[-0.35 * reach, -edge, 1.35 * reach + edge, shoulder + reach + 2 * edge]}
          centre={[0, shoulder]}
          reach={reach}
          places={places}
          project={FROM_THE_SIDE}
          column={shoulder}
        />
      </div>
      <figcaption className={styles.caption}>
        <span className={keys.key}>
          <i data-key="next" /> {t("ui-place-next")} <i data-key="done" /> {t(done)} <i data-key="todo" />{" "}
          {t("ui-to-do")}
        </span>
      </figcaption>
    </figure>
  );
}

interface ViewProps {
  title: string;
  /** Left, bottom, width and height in mm. */
  box: [number, number, number, number];
  centre: [number, number];
  reach: number;
  places: StandardMark[];
  project: Projection;
  /** Height of the arm's column, if it is seen. */
  column?: number;
}

function View({ title, box: [left, bottom, width, height], centre, reach, places, project, column }: ViewProps) {
  /* what is done now is drawn over the others */
  const ordered = [...places].sort((a, b) => Number(a.state === "now") - Number(b.state === "now"));
  const unit = reach / 100;
  const lines = ordered.map((place) => ({ place, line: projectEnds(place, project) }));
  return (
    <div className={styles.drawing}>
      <svg
        className={styles.view}
        viewBox={`${left} ${-bottom - height} ${width} ${height}`}
        role="img"
        aria-label={title}
      >
        <circle className={styles.reach} cx={centre[0]} cy={-centre[1]} r={reach} strokeWidth={0.5 * unit} />
        {column !== undefined && (
          <>
            <line className={styles.table} x1={left} x2={left + width} y1={0} y2={0} strokeWidth={0.6 * unit} />
            <line className={styles.arm} x1={0} x2={0} y1={0} y2={-column} strokeWidth={5 * unit} />
          </>
        )}
        <circle className={styles.base} cx={centre[0]} cy={-centre[1]} r={4 * unit} />
        {placeLabels(lines, LABEL_APART * unit).map((drawn) => (
          <Standard
            key={drawn.place.number}
            {...drawn}
            unit={unit}
            labelled={places.length <= MOST_LABELS || drawn.place.state === "now"}
          />
        ))}
      </svg>
      <span aria-hidden="true" className={styles.name}>
        {title}
      </span>
    </div>
  );
}

function projectEnds(place: StandardMark, project: Projection): readonly [Point, Point] {
  const [from, to] = place.ends_mm as [[number, number, number], [number, number, number]];
  return [project(from), project(to)];
}

interface StandardProps {
  place: StandardMark;
  line: readonly [Point, Point];
  label: Point;
  unit: number;
  labelled: boolean;
}

function Standard({ place, line: [[x1, y1], [x2, y2]], label: [x, y], unit, labelled }: StandardProps) {
  return (
    <g className={styles.standard} data-state={place.state} data-place={place.number}>
      <line x1={x1} y1={-y1} x2={x2} y2={-y2} strokeWidth={(place.state === "now" ? 3.5 : 2) * unit} />
      {labelled && (
        <>
          <circle cx={x} cy={-y} r={5 * unit} />
          <text x={x} y={-y} fontSize={6.5 * unit}>
            {place.number}
          </text>
        </>
      )}
    </g>
  );
}
