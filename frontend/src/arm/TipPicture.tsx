import type { ArmPicture, FigureLine } from "../api/wire";
import { FigureBars } from "../gauges/quick/FigureBars";
import { TouchView } from "../gauges/quick/TouchView";
import { t } from "../state/language";
import styles from "./TipPicture.module.css";

/** The contact points on the sphere and, after their evaluation, the figures of the tip. */
export function TipPicture({ picture }: { picture: ArmPicture }) {
  const { tip, touches, sphere_mm } = picture;
  return (
    <div className={styles.picture}>
      <TouchView picture={{ shape: "sphere", radius_mm: sphere_mm, touches }} />
      {tip && (
        <div className={styles.figures}>
          <FigureBars found={figuresOf(tip)} />
        </div>
      )}
    </div>
  );
}

function figuresOf(tip: NonNullable<ArmPicture["tip"]>): FigureLine[] {
  const { limit_um: limit } = tip;
  const within = limit === null ? "none" : tip.scatter_um > limit ? "fail" : "pass";
  const line = {
    unit: "µm",
    limit,
    reason: "",
    clouds: [],
    budget: {},
    spread: {},
    test_uncertainty: null,
    judged_by: "measurement" as const,
  };
  return [
    {
      ...line,
      name: "radius_error",
      title: t("ui-diameter-error"),
      value: tip.error_um,
      expanded_uncertainty: tip.expanded_uncertainty_um,
      decision: tip.error_decision ?? tip.decision,
    },
    {
      ...line,
      name: "scatter",
      title: t("ui-largest-distance-of-a-contact-point"),
      value: tip.scatter_um,
      expanded_uncertainty: 0,
      decision: within,
    },
    ...(tip.bend_um === null
      ? []
      : [
          {
            ...line,
            limit: null,
            name: "bend",
            title: t("ui-distance-tips-centre-place"),
            value: tip.bend_um,
            expanded_uncertainty: 0,
            decision: "none" as const,
          },
        ]),
  ];
}
