import type { ReactNode } from "react";
import type { ShapeParameter } from "../api/wire";
import { CloseIcon } from "../controls/icons";
import { lengthFigures, measured, unitOf } from "../controls/lengths";
import { partQuantity, uncertaintyDecimals, uncertaintyQuantity } from "../controls/uncertainty";
import { render, t } from "../state/language";
import styles from "./MeasurePanel.module.css";

/** The name of a shape or of two, with what removes the card. */
export function CardHeader({ name, onRemove }: { name: string; onRemove?: (() => void) | undefined }) {
  return (
    <header className={styles.head}>
      <h3 className={styles.name}>{name}</h3>
      {onRemove && (
        <button type="button" className={styles.remove} onClick={onRemove} aria-label={t("ui-remove-name", { name })}>
          <CloseIcon size="1.25rem" />
        </button>
      )}
    </header>
  );
}

/** The figure that is read from afar, and what it is known to. */
export function MainFigure({ figure }: { figure: ShapeParameter }) {
  return (
    <p className={styles.main}>
      <span className={styles.mainLabel}>{figure.label}</span>
      {lengthFigures(figure.value, figure.unit, decimalsOf(figure))}
      {figure.unit === "°" ? "" : " "}
      <span className={styles.mainUnit}>{unitOf(figure.unit)}</span>
      <Known figure={figure} />
    </p>
  );
}

/** One of the other figures. */
export function FigureRow({ figure }: { figure: ShapeParameter }) {
  return (
    <Row label={figure.label}>
      {measured(figure.value, figure.unit, decimalsOf(figure))}
      <Known figure={figure} />
    </Row>
  );
}

export function Row({ label, children }: { label: string; children: ReactNode }) {
  return (
    <div className={styles.row}>
      <dt>{label}</dt>
      <dd>{children}</dd>
    </div>
  );
}

/** U, or else the scatter that is none; and what chance alone would show of a value near zero. */
function Known({ figure: { expanded, scatter, by_chance, unit } }: { figure: ShapeParameter }) {
  return (
    <>
      {expanded !== null && (
        <span className={styles.known}>
          {t("ui-expanded-uncertainty", { u: render(uncertaintyQuantity(expanded, unit)) })}
        </span>
      )}
      {scatter !== null && (
        <span className={styles.known}>
          {t("ui-scatter-of", { scatter: render(uncertaintyQuantity(scatter, unit)) })}
        </span>
      )}
      {by_chance !== null && (
        <span className={styles.known}>
          {t("ui-by-chance-alone", { value: render(uncertaintyQuantity(by_chance, unit)) })}
        </span>
      )}
    </>
  );
}

/** Why a card states no uncertainty; nothing if it does. */
export function WhyScatter({ figures, why }: { figures: readonly ShapeParameter[]; why: string }) {
  if (!why) return null;
  const known = figures.some((figure) => figure.scatter !== null);
  return (
    <p className={styles.note}>
      {why} {t(known ? "ui-scatter-of-the-scan-is-no-uncertainty" : "ui-too-few-pictures-for-their-scatter")}
    </p>
  );
}

/** What the uncertainty of a figure is made of, on demand. */
export function Budget({ figure }: { figure: ShapeParameter }) {
  const { expanded, shares, unit } = figure;
  if (expanded === null || !shares.length) return null;
  const most = Math.max(...shares.map((share) => share.expanded));
  return (
    <details className={styles.more}>
      <summary>{t("ui-what-u-is-made-of")}</summary>
      <p className={styles.note}>{figure.label}</p>
      <dl className={styles.rows}>
        {shares.map((share) => (
          <div key={share.source} className={styles.share}>
            <dt>{share.source}</dt>
            <dd>{render(partQuantity(share.expanded, expanded, unit))}</dd>
            <span className={styles.bar} style={{ width: `${(100 * share.expanded) / most}%` }} />
          </div>
        ))}
      </dl>
      <p className={styles.note}>{t("ui-squares-of-shares-add-up")}</p>
    </details>
  );
}

/** As many as its uncertainty has. */
function decimalsOf({ expanded, scatter, decimals, unit }: ShapeParameter): number {
  const known = expanded ?? scatter;
  return known === null ? decimals : uncertaintyDecimals(known, unit);
}
