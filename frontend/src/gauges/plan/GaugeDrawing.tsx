import styles from "./GaugeDrawing.module.css";

/** A clamped plate or sphere on its foot, with the places to touch, or the stripe. */
export function GaugeDrawing({
  shape,
  touching = false,
  scanning = false,
}: {
  shape: "plane" | "sphere" | null;
  touching?: boolean;
  scanning?: boolean;
}) {
  return (
    <svg className={styles.drawing} viewBox="0 0 320 220" aria-hidden="true">
      {shape === "sphere" ? (
        <Sphere touching={touching} scanning={scanning} />
      ) : (
        <Plate touching={touching} scanning={scanning} />
      )}
    </svg>
  );
}

interface Marks {
  touching: boolean;
  scanning: boolean;
}

function Plate({ touching, scanning }: Marks) {
  const spots = [
    [76, 119],
    [182, 79],
    [247, 115],
    [141, 147],
    [161, 115],
  ];
  return (
    <>
      <path className={styles.side} d="M40 122 132 160v22L40 144Z" />
      <path className={styles.front} d="M132 160 284 116v22L132 182Z" />
      <path className={styles.top} d="M40 122 190 62l94 54-152 44Z" />
      {scanning && <path className={styles.stripe} d="M108 95 200 140" />}
      {touching && spots.map(([x, y]) => <ellipse key={x} className={styles.spot} cx={x} cy={y} rx={8} ry={5} />)}
    </>
  );
}

function Sphere({ touching, scanning }: Marks) {
  const spots = [
    [160, 38],
    [112, 68],
    [208, 68],
    [146, 84],
    [196, 104],
    [118, 112],
  ];
  return (
    <>
      <path className={styles.side} d="M152 150h16v44h-16z" />
      <ellipse className={styles.front} cx={160} cy={196} rx={56} ry={13} />
      <circle className={styles.top} cx={160} cy={96} r={66} />
      <ellipse className={styles.ring} cx={160} cy={96} rx={66} ry={20} />
      {scanning && <path className={styles.stripe} d="M136 36c-16 34-16 84 0 120" />}
      {touching && spots.map(([x, y]) => <circle key={x} className={styles.spot} cx={x} cy={y} r={7} />)}
    </>
  );
}
