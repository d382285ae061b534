import type { FormEvent } from "react";

import { sendArm } from "../api/armCommands";
import { PressButton } from "../parts/PressButton";
import { useHeld } from "../state/useHeld";
import styles from "./Fields.module.css";
import { UnitInput } from "./UnitInput";

/** The largest (max − min)/2 that the operator accepts; kept for the next checks. */
export function LimitField({ limit_um, tip }: { limit_um: number | null; tip: boolean }) {
  const limit = useHeld(limit_um === null ? "" : String(limit_um));
  const set = () => sendArm("set_limit", { limit_um: limit.text.trim() === "" ? null : Number(limit.text) });
  const submit = (event: FormEvent) => {
    event.preventDefault();
    void set();
  };
  return (
    <form className={styles.field} onSubmit={submit}>
      <label className={styles.label} htmlFor="arm-limit">
        {tip ? "Limit of the diameter's error and of the scatter" : "Limit of (max − min)/2 on each axis"}
      </label>
      <div className={styles.row}>
        <UnitInput
          id="arm-limit"
          unit="µm"
          min={1}
          max={100000}
          value={limit.text}
          placeholder="none"
          onText={limit.setText}
        />
        {limit.changed && <PressButton onPress={set}>Set</PressButton>}
      </div>
    </form>
  );
}
