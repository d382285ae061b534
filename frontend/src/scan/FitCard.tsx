import { changeShape, colourBy, removeFit } from "../api/viewCommands";
import type { FittedShape, ShapeParameter } from "../api/wire";
import look from "../controls/Control.module.css";
import { figures } from "../controls/figures";
import { measured } from "../controls/lengths";
import { useBarred } from "../state/control";
import { t } from "../state/language";
import { useLive } from "../state/store";
import { Budget, CardHeader, FigureRow, MainFigure, Row, WhyScatter } from "./figureParts";
import styles from "./MeasurePanel.module.css";
import { NAMES, nameOf } from "./shapeNames";

/** A fitted shape: what it measures, how well that is known, and what it is fitted to. */
export function FitCard({ fitted, last }: { fitted: FittedShape; last: boolean }) {
  const barred = useBarred() !== "";
  const byDeviation = useLive((s) => s.view?.measure === "deviation");
  const { second } = fitted;
  // for a plane, the form comes first; for others, their size
  const flat = fitted.shape === "plane";
  const [first, ...rest] = fitted.figures;
  const main: ShapeParameter | undefined = flat ? formOf(fitted) : first;
  const others = flat ? fitted.figures : rest;
  return (
    <article className={styles.fit}>
      <CardHeader name={nameOf(fitted)} onRemove={barred ? undefined : () => void removeFit(fitted.id)} />
      {main && <MainFigure figure={main} />}
      {!barred && second && (
        <button
          type="button"
          className={`${look.button} ${styles.second}`}
          onClick={() => void changeShape(fitted.id, second)}
        >
          {t("ui-fit-instead", { shape: t(NAMES[second]) })}
        </button>
      )}
      <dl className={styles.rows}>
        {others.map((figure) => (
          <FigureRow key={figure.label} figure={figure} />
        ))}
      </dl>
      <WhyScatter figures={fitted.figures} why={fitted.why_scatter} />
      {first && <Budget figure={first} />}
      <details className={styles.more}>
        <summary>{t("ui-points-and-fit")}</summary>
        <dl className={styles.rows}>
          {!flat && <Row label={t(FORM)}>{micrometres(fitted.form_um)}</Row>}
          <Row label={t("ui-distances-rms")}>{micrometres(fitted.rms_um)}</Row>
          <Row label={t("ui-largest-distance")}>{micrometres(fitted.largest_um)}</Row>
          <Row label={t("ui-points-used")}>{figures(fitted.points)}</Row>
          <Row label={t("ui-left-out-on-other-surfaces")}>{figures(fitted.other_surfaces)}</Row>
          <Row label={t("ui-left-out-at-edges")}>{figures(fitted.at_edges)}</Row>
          <Row label={t("ui-left-out-as-outliers")}>{figures(fitted.outliers)}</Row>
        </dl>
        {(fitted.points + fitted.other_surfaces + fitted.at_edges + fitted.outliers < fitted.picked ||
          !fitted.every) && (
          <p className={styles.note}>
            {fitted.every ? t("ui-evenly-of-points", { all: fitted.picked }) : t("ui-thinned-cloud-picture")}
          </p>
        )}
      </details>
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

const FORM = "ui-form-highest-to-lowest";

function formOf({ form_um }: FittedShape): ShapeParameter {
  return {
    label: t(FORM),
    value: form_um,
    unit: "µm",
    decimals: form_um < 10 ? 1 : 0,
    expanded: null,
    scatter: null,
    shares: [],
    by_chance: null,
  };
}

const micrometres = (value: number) => measured(value, "µm", value < 10 ? 1 : 0);
