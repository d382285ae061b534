import type { DriftHistory, DriftPoint } from "../api/wire";
import { moment } from "../controls/format";
import { measured } from "../controls/lengths";
import { decimalsOf, qualityOf } from "./answers";
import styles from "./FleetPage.module.css";
import { Dot, HEIGHT, Plot, type Range, WIDTH } from "./Plot";

/** A figure over time with its limit; bands are where a change happened (95 %), the line is the level that is taken as right. */
export function DriftChart({
  points,
  history,
  range,
  label,
}: {
  points: DriftPoint[];
  history: DriftHistory;
  range: Range;
  label: string;
}) {
  const limit = points.flatMap((one) => (one.limit === null ? [] : [one.limit]))[0];
  const { changes, right } = history;
  const unit = points[0]?.unit ?? "";
  const day = (time: number) => moment(new Date(time).toISOString());
  return (
    <Plot range={range} unit={unit} ends={[day(range.from), day(range.to)]} label={label}>
      {({ x, y }) => (
        <>
          {changes.map((one) => {
            const from = x(Date.parse(one.earliest));
            const width = Math.max(x(Date.parse(one.latest)) - from, 3);
            return <rect key={one.by} className={styles.band} x={from} width={width} y="0" height={HEIGHT} />;
          })}
          {limit !== undefined && <line className={styles.limit} x1="0" x2={WIDTH} y1={y(limit)} y2={y(limit)} />}
          {right && changes.length > 0 && (
            <line className={styles.rightLevel} x1="0" x2={WIDTH} y1={y(right.value)} y2={y(right.value)} />
          )}
          <polyline
            className={styles.line}
            points={points.map((one) => `${x(Date.parse(one.at))},${y(one.value)}`).join(" ")}
          />
          {points.map((one) => (
            <Dot
              key={one.record_key}
              x={x(Date.parse(one.at))}
              y={y(one.value)}
              quality={qualityOf(one.decision)}
              title={`${moment(one.at)}: ${measured(one.value, unit, decimalsOf(unit))}`}
            />
          ))}
        </>
      )}
    </Plot>
  );
}
