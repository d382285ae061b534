import { useId } from "react";

import { setValue } from "../../api/guideCommands";
import type { PerformanceLimitLine } from "../../api/wire";
import { unitOf } from "../../controls/lengths";
import { PressButton } from "../../controls/PressButton";
import { UnitInput } from "../../controls/UnitInput";
import { useFieldForm } from "../../controls/useFieldForm";
import { useLengthField } from "../../controls/useLengthField";
import { t } from "../../state/language";
import styles from "./ArtefactChoice.module.css";

/** The limits by the datasheet; a limit of lengths has three numbers. */
export function Limits({ limits }: { limits: PerformanceLimitLine[] }) {
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
  const a = useLengthField(limit.a_um, "µm");
  const k = useLengthField(limit.k, "");
  const b = useLengthField(limit.b_um, "µm");
  const set = () => {
    const grows = limit.grows && a.value !== null ? { k: k.value, b_um: b.value } : {};
    return setValue("performance", "set_limit", { quantity: limit.quantity, a_um: a.value, ...grows });
  };
  const { changed, valid, form } = useFieldForm([a, k, b], set);
  const id = useId();
  return (
    <li>
      <form className={styles.limit} aria-label={limit.grows ? limit.title : undefined} {...form}>
        <label htmlFor={id} className={styles.what}>
          <span className={styles.title}>{limit.title}</span>
          <span className={styles.symbol}>{limit.symbol}</span>
          {limit.grows && <span className={styles.symbol}>{t("ui-limit-grows-with-length")}</span>}
        </label>
        {limit.grows ? (
          <div className={styles.numbers}>
            <Letter letter="A" id={id} field={a} unit={unitOf("µm")} />
            <Letter letter="K" field={k} unit="" />
            <Letter letter="B" field={b} unit={unitOf("µm")} />
          </div>
        ) : (
          <UnitInput id={id} unit={unitOf("µm")} value={a.text} placeholder={t("ui-limit-none")} onText={a.setText} />
        )}
        {changed && (
          <PressButton onPress={set} disabled={!valid}>
            {t("ui-set")}
          </PressButton>
        )}
      </form>
    </li>
  );
}

interface LetterProps {
  letter: string;
  id?: string;
  field: ReturnType<typeof useLengthField>;
  unit: string;
}

/** One number of a limit, by its letter of the datasheet. */
function Letter({ letter, id, field, unit }: LetterProps) {
  return (
    <div className={styles.number}>
      <span aria-hidden="true">{letter}</span>
      <UnitInput
        {...(id && { id })}
        unit={unit}
        value={field.text}
        placeholder={t("ui-limit-none")}
        aria-label={letter}
        onText={field.setText}
      />
    </div>
  );
}
