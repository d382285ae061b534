import { useState } from "react";

import styles from "../access/Access.module.css";
import { useReread } from "../access/useReread";
import { addMetricsToken, removeMetricsToken } from "../api/watchCommands";
import type { ApiTokenSummary } from "../api/wire";
import { moment } from "../parts/format";
import rows from "../parts/List.module.css";
import { PressButton } from "../parts/PressButton";
import { TextField } from "../parts/TextField";
import { isolated } from "../state/isolated";
import { t } from "../state/language";

/** Tokens by which programs read the metrics. */
export function MetricsTokens() {
  const { list, reread } = useReread<ApiTokenSummary>("/api/tokens");
  const [name, setName] = useState("");
  const [token, setToken] = useState("");
  const add = async () => {
    const made = await addMetricsToken(name);
    if (!made?.token) return;
    setToken(made.token);
    setName("");
    await reread();
  };
  const remove = async (id: string) => {
    await removeMetricsToken(id);
    setToken("");
    await reread();
  };
  return (
    <section className={styles.section} aria-label={t("ui-metrics")}>
      <h2 className={styles.title}>{t("ui-metrics")}</h2>
      <p className={styles.text}>{t("ui-prometheus-reads", { address: `${window.location.origin}/metrics` })}</p>
      {list && list.length > 0 && (
        <ul className={rows.list}>
          {list.map((one) => (
            <li key={one.id} className={styles.row}>
              <div className={styles.words}>
                <strong>{isolated(one.name)}</strong>
                <span>{t("ui-created-by", { name: one.made_by, when: moment(one.made_at) })}</span>
              </div>
              <PressButton free kind="quiet" onPress={() => remove(one.id)}>
                {t("ui-revoke-this-token")}
              </PressButton>
            </li>
          ))}
        </ul>
      )}
      {token && (
        <div className={styles.link} role="status">
          <p>{t("ui-enter-program-appears-only-once")}</p>
          <code>{token}</code>
        </div>
      )}
      <div className={styles.line}>
        <TextField
          label={t("ui-new-token")}
          placeholder={t("ui-name-of-the-program")}
          value={name}
          maxLength={60}
          onText={setName}
        />
        <PressButton free disabled={!name.trim()} onPress={add}>
          {t("ui-create-token")}
        </PressButton>
      </div>
    </section>
  );
}
