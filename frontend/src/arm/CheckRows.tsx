import type { ArmCheckSummary, IdentificationSummary, TipCheckSummary } from "../api/wire";
import { moment } from "../controls/format";
import { lengthFigures, measured, unitOf } from "../controls/lengths";
import { limitBeside } from "../controls/limits";
import { QualityMark } from "../controls/QualityMark";
import { Reports } from "../controls/Reports";
import { t } from "../state/language";
import styles from "./History.module.css";

/** An arm check, with its report. */
export function ArmRow({ check }: { check: ArmCheckSummary }) {
  const limit =
    check.limit_um === null ? t("ui-no-limit-set") : t("ui-limit-value", { value: limitBeside(check.limit_um, "µm") });
  return (
    <li className={styles.row}>
      <QualityMark quality={check.verdict} />
      <div className={styles.what}>
        <p className={styles.when}>
          {t("ui-arm-check")} · {moment(check.at)}
        </p>
        <p className={styles.detail}>
          {t("ui-arm-serial", { serial: check.arm_serial || check.arm_name })} · {t("ui-n-points", { n: check.points })}{" "}
          · {limit}
        </p>
      </div>
      <div className={styles.figures}>
        <Axes label="(max − min)/2" values={check.half_range_um} />
        <Axes label="2σ" values={check.two_sigma_um} />
        {typeof check.largest_um === "number" && typeof check.two_s_um === "number" && (
          <dl className={styles.axes}>
            <dt>{t("ui-in-space-largest-2s")}</dt>
            <dd>
              {[check.largest_um, check.two_s_um].map((value) => lengthFigures(value, "µm")).join(" · ")} {unitOf("µm")}
            </dd>
          </dl>
        )}
      </div>
      <Reports of={`/api/arm/checks/${check.id}`} />
    </li>
  );
}

/** A tip check, with its report. */
export function TipRow({ check }: { check: TipCheckSummary }) {
  return (
    <li className={styles.row}>
      <QualityMark quality={check.verdict} />
      <div className={styles.what}>
        <p className={styles.when}>
          {t("ui-tip-check")} · {moment(check.at)}
        </p>
        <p className={styles.detail}>{check.text}</p>
      </div>
      <dl className={styles.axes}>
        <dt>{t("ui-diameter")}</dt>
        <dd>{measured(check.diameter_mm, "mm", 3)}</dd>
      </dl>
      <Reports of={`/api/arm/tips/${check.id}`} />
    </li>
  );
}

/** An identification of the arm, with its report. */
export function IdentifiedRow({ found }: { found: IdentificationSummary }) {
  return (
    <li className={styles.row}>
      <QualityMark quality="neutral" />
      <div className={styles.what}>
        <p className={styles.when}>
          {t("ui-arm-identification")} · {moment(found.at)}
        </p>
        <p className={styles.detail}>
          {t("ui-arm-serial", { serial: found.arm_serial || found.arm_name })}
          {!found.size_known && ` · ${t("ui-scale-from-the-datasheet")}`}
        </p>
      </div>
      <dl className={styles.axes}>
        <dt>{t("ui-tip-error-over-the-reach-rms")}</dt>
        <dd>
          {lengthFigures(found.volume_before_um, "µm", 1)} → {measured(found.volume_after_um, "µm", 1)}
        </dd>
      </dl>
      <Reports of={`/api/arm/identifications/${found.id}`} />
    </li>
  );
}

function Axes({ label, values }: { label: string; values: number[] }) {
  return (
    <dl className={styles.axes}>
      <dt>{label} x, y, z</dt>
      <dd>
        {values.map((value) => lengthFigures(value, "µm")).join(" · ")} {unitOf("µm")}
      </dd>
    </dl>
  );
}
