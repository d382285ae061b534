import type { SeatLine } from "../api/wire";
import { EmptyState } from "../controls/EmptyState";
import { measured } from "../controls/lengths";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import { SeatIllustration } from "./SeatIllustration";
import styles from "./SeatList.module.css";

/** The seats taken so far, each with the apparent motion of the tip. */
export function SeatList({ seats }: { seats: SeatLine[] }) {
  if (seats.length === 0) {
    return (
      <EmptyState
        picture={<SeatIllustration />}
        title={t("ui-six-places-determine-the-arms-geometry")}
        text={t("ui-seat-end-ball-bar-tip-stays")}
      />
    );
  }
  const largest = Math.max(...seats.map((seat) => seat.half_range_um));
  return (
    <div className={styles.seats}>
      <h2 className={styles.title}>{t("ui-places-far-apparent-motion-tip-max")}</h2>
      <ul className={styles.list}>
        {seats.map((seat) => (
          <li key={seat.name} className={styles.seat}>
            <span className={styles.name}>{isolated(seat.name)}</span>
            <span className={styles.track}>
              <span className={styles.bar} style={{ width: `${(100 * seat.half_range_um) / largest}%` }} />
            </span>
            <span className={styles.value}>{measured(seat.half_range_um, "µm")}</span>
            <span className={styles.points}>{seat.note || t("ui-n-points", { n: seat.points })}</span>
          </li>
        ))}
      </ul>
    </div>
  );
}
