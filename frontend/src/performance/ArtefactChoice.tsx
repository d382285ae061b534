import { type FormEvent, useId } from "react";

import { sendCommand } from "../api/guideCommands";
import type { PerformanceLimitLine, PerformanceView } from "../api/wire";
import { ChoiceGroup } from "../flow/ChoiceGroup";
import { Chips } from "../parts/Chips";
import { EmptyState } from "../parts/EmptyState";
import { unitOf } from "../parts/lengths";
import { PressButton } from "../parts/PressButton";
import { UnitInput } from "../parts/UnitInput";
import { useLengthField } from "../parts/useLengthField";
import { t } from "../state/language";
import { GaugeDrawing } from "../verify/GaugeDrawing";
import styles from "./ArtefactChoice.module.css";
import { CertificateUpload } from "./CertificateUpload";

/** The sphere, the number of positions, and the limits by the datasheet. */
export function ArtefactChoice({ view }: { view: PerformanceView }) {
  if (view.gauges.length === 0)
    return (
      <div className={styles.choice}>
        <EmptyState
          picture={<GaugeDrawing shape="sphere" />}
          title={t("ui-no-gauge-yet")}
          text={t("ui-put-datasheet-plate-sphere-into-folder")}
        />
        <CertificateUpload />
      </div>
    );
  return (
    <div className={styles.choice}>
      <ChoiceGroup
        title={t("ui-test-sphere")}
        options={view.gauges}
        selected={view.gauge}
        onChoose={(id) => void sendCommand("performance", "choose_gauge", { id })}
      />
      <CertificateUpload />
      <section>
        <h3 className={styles.heading}>{t("ui-positions-of-the-sphere")}</h3>
        <Chips
          label={t("ui-positions-of-the-sphere")}
          options={[
            { value: 1, label: t("ui-one-position") },
            { value: 2, label: t("ui-two-positions") },
          ]}
          value={view.positions}
          onChange={(number) => void sendCommand("performance", "set_positions", { number })}
        />
      </section>
      <Limits limits={view.picture.limits} />
    </div>
  );
}

function Limits({ limits }: { limits: PerformanceLimitLine[] }) {
  return (
    <section>
      <h3 className={styles.heading}>{t("ui-limits-by-the-datasheet")}</h3>
      <p className={styles.text}>{t("ui-limits-fixed-at-first-touch")}</p>
      <ul className={styles.limits}>
        {limits.map((limit) => (
          <Limit key={limit.quantity} limit={limit} />
        ))}
      </ul>
    </section>
  );
}

function Limit({ limit }: { limit: PerformanceLimitLine }) {
  const id = useId();
  const field = useLengthField(limit.a_um, "µm");
  const set = () => sendCommand("performance", "set_limit", { quantity: limit.quantity, a_um: field.value });
  const submit = (event: FormEvent) => {
    event.preventDefault();
    if (field.valid) void set();
  };
  return (
    <li>
      <form className={styles.limit} onSubmit={submit}>
        <label htmlFor={id} className={styles.what}>
          <span className={styles.title}>{limit.title}</span>
          <span className={styles.symbol}>{limit.symbol}</span>
        </label>
        <UnitInput id={id} unit={unitOf("µm")} value={field.text} placeholder={t("ui-none")} onText={field.setText} />
        {field.changed && (
          <PressButton onPress={set} disabled={!field.valid}>
            {t("ui-set")}
          </PressButton>
        )}
      </form>
    </li>
  );
}
