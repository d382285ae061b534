import type { SeatLine } from "../api/armTypes";
import { EmptyState } from "../parts/EmptyState";
import { figures, plural } from "../parts/format";
import { SeatIllustration } from "./SeatIllustration";
import styles from "./SeatList.module.css";

/** The seats taken so far, each with what the tip seems to move by in it. */
export function SeatList({ seats }: { seats: SeatLine[] }) {
  if (seats.length === 0) {
    return (
      <EmptyState
        picture={<SeatIllustration />}
        title="Six seats tell the arm's geometry"
        text="In each the tip stays in one place while the arm swings. Put them all over the reach: near and far, left and right, high and low, and come back into each with the elbow on the other side."
      />
    );
  }
  const largest = Math.max(...seats.map((seat) => seat.half_range_um));
  return (
    <div className={styles.seats}>
      <h2 className={styles.title}>Seats so far: (max − min)/2 on the worst axis</h2>
      <ul className={styles.list}>
        {seats.map((seat) => (
          <li key={seat.name} className={styles.seat}>
            <span className={styles.name}>{seat.name}</span>
            <span className={styles.track}>
              <span className={styles.bar} style={{ width: `${(100 * seat.half_range_um) / largest}%` }} />
            </span>
            <span className={styles.value}>{figures(seat.half_range_um)} µm</span>
            <span className={styles.points}>{plural(seat.points, "point")}</span>
          </li>
        ))}
      </ul>
    </div>
  );
}
