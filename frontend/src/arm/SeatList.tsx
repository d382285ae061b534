import type { SeatLine } from "../api/armTypes";
import { EmptyState } from "../parts/EmptyState";
import { measured } from "../parts/lengths";
import { counted, said, t } from "../state/language";
import { SeatIllustration } from "./SeatIllustration";
import styles from "./SeatList.module.css";

/** The seats taken so far, each with what the tip seems to move by in it. */
export function SeatList({ seats }: { seats: SeatLine[] }) {
  if (seats.length === 0) {
    return (
      <EmptyState
        picture={<SeatIllustration />}
        title={t("Six places tell the arm's geometry")}
        text={t("In a seat, or an end of a ball bar, the tip stays in one place while the arm swings; a sphere is touched from every side. Put them all over the reach: near and far, left and right, high and low, and come back with the elbow on the other side. A ball bar tells the arm's size too.")}
      />
    );
  }
  const largest = Math.max(...seats.map((seat) => seat.half_range_um));
  return (
    <div className={styles.seats}>
      <h2 className={styles.title}>{t("Places so far: what the tip seems to move by, (max − min)/2")}</h2>
      <ul className={styles.list}>
        {seats.map((seat) => (
          <li key={seat.name} className={styles.seat}>
            <span className={styles.name}>{said(seat.name)}</span>
            <span className={styles.track}>
              <span className={styles.bar} style={{ width: `${(100 * seat.half_range_um) / largest}%` }} />
            </span>
            <span className={styles.value}>{measured(seat.half_range_um, "µm")}</span>
            <span className={styles.points}>{seat.note || counted(seat.points, "{n} point", "{n} points")}</span>
          </li>
        ))}
      </ul>
    </div>
  );
}
