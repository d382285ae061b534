import type { ReactNode } from "react";
import type { ShapeName } from "../api/types";
import { colourBy, removeFit } from "../api/viewCommands";
import type { FittedShape, ShapeParameter } from "../api/wire";
import look from "../controls/Control.module.css";
import { CloseIcon, CylinderIcon, PlaneIcon, SphereIcon } from "../controls/icons";
import { lengthFigures, measured, unitOf } from "../controls/lengths";
import type { PlainId } from "../messages/text";
import { useBarred } from "../state/control";
import { t } from "../state/language";
import { useLive } from "../state/store";
import styles from "./MeasurePanel.module.css";

const NAMES: Record<ShapeName, PlainId> = { plane: "ui-plane", sphere: "ui-sphere", cylinder: "ui-cylinder" };
const SHAPES: { name: ShapeName; icon: ReactNode }[] = [
  { name: "plane", icon: <PlaneIcon /> },
  { name: "sphere", icon: <SphereIcon /> },
  { name: "cylinder", icon: <CylinderIcon /> },
];

/** Fitted shapes, the newest first. */
export function MeasurePanel({ onPick }: { onPick: (shape: ShapeName) => void }) {
  const fits = useLive((s) => s.view?.fits);
  const barred = useBarred() !== "";
  const busy = useLive((s) => s.view?.busy ?? "");
  const some = useLive((s) => Boolean(s.view?.legend));
  const why = busy ? busy : some ? "" : t("ui-no-cloud-picture-yet-scan-display");
  return (
    <>
      <h2 className={styles.title}>{t("ui-fit-a-shape")}</h2>
      <div className={styles.shapes}>
        {SHAPES.map((shape) => (
          <button
            key={shape.name}
            type="button"
            className={`${look.button} ${styles.shape}`}
            aria-disabled={barred || why !== "" || undefined}
            onClick={() => !barred && !why && onPick(shape.name)}
          >
            {shape.icon}
            {t(NAMES[shape.name])}
          </button>
        ))}
      </div>
      {why && (
        <p className={styles.why} role="status">
          {why}
        </p>
      )}
      {[...(fits ?? [])].reverse().map((fitted, i) => (
        <FitCard key={fitted.id} fitted={fitted} last={i === 0} />
      ))}
    </>
  );
}

function FitCard({ fitted, last }: { fitted: FittedShape; last: boolean }) {
  const barred = useBarred() !== "";
  const byDeviation = useLive((s) => s.view?.measure === "deviation");
  const label = t(NAMES[fitted.shape]);
  // for a plane, the form comes first; for round shapes, the diameter
  const flat = fitted.shape === "plane";
  const [first, ...rest] = fitted.figures;
  const main: ShapeParameter | undefined = flat ? formOf(fitted) : first;
  const others = flat ? fitted.figures : rest;
  return (
    <article className={styles.fit}>
      <header className={styles.head}>
        <h3 className={styles.name}>
          {label} {fitted.id}
        </h3>
        {!barred && (
          <button
            type="button"
            className={styles.remove}
            onClick={() => void removeFit(fitted.id)}
            aria-label={t("ui-remove-name", { name: `${label} ${fitted.id}` })}
          >
            <CloseIcon size="1.25rem" />
          </button>
        )}
      </header>
      {main && (
        <p className={styles.main}>
          <span className={styles.mainLabel}>{main.label}</span>
          {lengthFigures(main.value, main.unit, main.decimals)}{" "}
          <span className={styles.mainUnit}>{unitOf(main.unit)}</span>
          <Scatter figure={main} />
        </p>
      )}
      <dl className={styles.rows}>
        {others.map((figure) => (
          <Row key={figure.label} label={figure.label}>
            {measured(figure.value, figure.unit, figure.decimals)} <Scatter figure={figure} />
          </Row>
        ))}
        {!flat && <Row label={t(FORM)}>{micrometres(fitted.form_um)}</Row>}
        <Row label={t("ui-distances-rms")}>{micrometres(fitted.rms_um)}</Row>
        <Row label={t("ui-largest-distance")}>{micrometres(fitted.largest_um)}</Row>
      </dl>
      <p className={styles.note}>
        {fitted.points < fitted.picked
          ? t("ui-of-points", { n: fitted.points, all: fitted.picked })
          : t("ui-n-points", { n: fitted.points })}
        {fitted.every ? "" : `, ${t("ui-thinned-cloud-picture")}`}.{" "}
        {fitted.figures.some((figure) => figure.scatter !== null)
          ? t("ui-scatter-of-the-scan-is-no-uncertainty")
          : t("ui-too-few-pictures-for-their-scatter")}
      </p>
      {last && !byDeviation && !barred && (
        <button
          type="button"
          className={`${look.button} ${styles.deviations}`}
          onClick={() => void colourBy("deviation")}
        >
          {t("ui-colour-by-deviation")}
        </button>
      )}
    </article>
  );
}

function Row({ label, children }: { label: string; children: ReactNode }) {
  return (
    <div className={styles.row}>
      <dt>{label}</dt>
      <dd>{children}</dd>
    </div>
  );
}

function Scatter({ figure }: { figure: ShapeParameter }) {
  if (figure.scatter === null) return null;
  const scatter = small(figure.scatter, figure.scatter_unit);
  return <span className={styles.known}>{t("ui-scatter-of", { scatter })}</span>;
}

const FORM = "ui-form-highest-to-lowest";

function formOf({ form_um }: FittedShape): ShapeParameter {
  const decimals = form_um < 10 ? 1 : 0;
  return { label: t(FORM), value: form_um, unit: "µm", decimals, scatter: null, scatter_unit: "" };
}

const small = (value: number, unit: string) => measured(value, unit, value < 10 ? 1 : 0);
const micrometres = (value: number) => small(value, "µm");
