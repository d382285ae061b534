import { type FormEvent, useEffect, useState } from "react";

import { sendArm } from "../api/armCommands";
import { PressButton } from "../parts/PressButton";
import styles from "./Fields.module.css";

/** The largest (max − min)/2 that the operator accepts; kept for the next checks. */
export function LimitField({ limit_um }: { limit_um: number | null }) {
  const held = limit_um === null ? "" : String(limit_um);
  const [text, setText] = useState(held);
  useEffect(() => setText(held), [held]);
  const set = () => sendArm("set_limit", { limit_um: text.trim() === "" ? null : Number(text) });
  const submit = (event: FormEvent) => {
    event.preventDefault();
    void set();
  };
  return (
    <form className={styles.field} onSubmit={submit}>
      <label className={styles.label} htmlFor="arm-limit">
        Limit of (max − min)/2 on each axis
      </label>
      <div className={styles.row}>
        <div className={styles.unit} data-unit="µm">
          <input
            id="arm-limit"
            className={styles.input}
            type="number"
            inputMode="decimal"
            min={1}
            max={100000}
            step="any"
            value={text}
            placeholder="none"
            onChange={(event) => setText(event.target.value)}
          />
        </div>
        {text !== held && <PressButton onPress={set}>Set</PressButton>}
      </div>
    </form>
  );
}
