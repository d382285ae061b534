import { removeFit } from "../api/viewCommands";
import type { ElementRelation, FittedShape } from "../api/wire";
import { useBarred } from "../state/control";
import { t } from "../state/language";
import { Budget, CardHeader, FigureRow, MainFigure, WhyScatter } from "./figureParts";
import styles from "./MeasurePanel.module.css";
import { nameOf } from "./shapeNames";

interface RelationCardProps {
  relation: ElementRelation;
  fits: readonly FittedShape[];
}

/** The dimensions between two shapes. */
export function RelationCard({ relation, fits }: RelationCardProps) {
  const barred = useBarred() !== "";
  const [first, second] = [relation.first, relation.second].map((id) => fits.find((one) => one.id === id));
  const [main, ...others] = relation.figures;
  if (!first || !second || !main) return null;
  const name = t("ui-names-of-two", { first: nameOf(first), second: nameOf(second) });
  return (
    <article className={styles.fit}>
      <CardHeader name={name} onRemove={barred ? undefined : () => void removeFit(relation.id)} />
      <MainFigure figure={main} />
      {others.length > 0 && (
        <dl className={styles.rows}>
          {others.map((figure) => (
            <FigureRow key={figure.label} figure={figure} />
          ))}
        </dl>
      )}
      <WhyScatter figures={relation.figures} why={relation.why_scatter} />
      <Budget figure={main} />
    </article>
  );
}
