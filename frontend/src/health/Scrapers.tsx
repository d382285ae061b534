import { useState } from "react";

import styles from "../access/Access.module.css";
import { useReread } from "../access/useReread";
import { addScraper, removeScraper } from "../api/watchCommands";
import type { Scraper } from "../api/watchTypes";
import rows from "../parts/List.module.css";
import { moment } from "../parts/format";
import { PressButton } from "../parts/PressButton";
import { TextField } from "../parts/TextField";
import { isolated } from "../state/isolated";
import { t } from "../state/language";

/** Tokens by which programs read the metrics. */
export function Scrapers() {
  const { list, reread } = useReread<Scraper>("/api/scrapers");
  const [name, setName] = useState("");
  const [token, setToken] = useState("");
  const add = async () => {
    const made = await addScraper(name);
    if (!made?.token) return;
    setToken(made.token);
    setName("");
    await reread();
  };
  const remove = async (id: string) => {
    await removeScraper(id);
    setToken("");
    await reread();
  };
  return (
    <section className={styles.section} aria-label={t("Metrics")}>
      <h2 className={styles.title}>{t("Metrics")}</h2>
      <p className={styles.text}>{t("Prometheus reads {address} with a token of its own, sent as Bearer.", { address: `${window.location.origin}/metrics` })}</p>
      {list && list.length > 0 && (
        <ul className={rows.list}>
          {list.map((one) => (
            <li key={one.id} className={styles.row}>
              <div className={styles.words}>
                <strong>{isolated(one.name)}</strong>
                <span>
                  {t("made by {name}, {when}", { name: one.made_by, when: moment(one.made_at) })}
                </span>
              </div>
              <PressButton free kind="quiet" onPress={() => remove(one.id)}>
                {t("End this token")}
              </PressButton>
            </li>
          ))}
        </ul>
      )}
      {token && (
        <div className={styles.link} role="status">
          <p>{t("Give this to the program. It is shown this once:")}</p>
          <code>{token}</code>
        </div>
      )}
      <div className={styles.line}>
        <TextField label={t("New token")} placeholder={t("Which program")} value={name} maxLength={60} onText={setName} />
        <PressButton free disabled={!name.trim()} onPress={add}>
          {t("Make a token")}
        </PressButton>
      </div>
    </section>
  );
}
