import { type ReactNode, useState } from "react";
import type { AccessTokenSummary } from "../api/wire";
import { moment } from "../controls/format";
import rows from "../controls/List.module.css";
import { PressButton } from "../controls/PressButton";
import { TextField } from "../controls/TextField";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import styles from "./Access.module.css";
import { useReread } from "./useReread";

interface Props {
  /** Where they are listed. */
  path: "/api/kiosk-links" | "/api/tokens";
  title: string;
  /** Above the list; the number is of those in it. */
  intro: (count: number) => ReactNode;
  /** Returns the text that is shown only once; empty if nothing was created. */
  add: (name: string) => Promise<string>;
  remove: (id: string) => Promise<unknown>;
  texts: { revoke: string; once: string; label: string; placeholder: string; create: string };
}

/** Kiosk links, or tokens for the metrics: the list, a new one, and the revocation of each. */
export function AccessTokens({ path, title, intro, add, remove, texts }: Props) {
  const { list, reread } = useReread<AccessTokenSummary>(path);
  const [name, setName] = useState("");
  const [secret, setSecret] = useState("");
  const create = async () => {
    const made = await add(name);
    if (!made) return;
    setSecret(made);
    setName("");
    await reread();
  };
  const revoke = async (id: string) => {
    await remove(id);
    setSecret("");
    await reread();
  };
  return (
    <section className={styles.section} aria-label={title}>
      <h2 className={rows.heading}>{title}</h2>
      {list && intro(list.length)}
      {list && list.length > 0 && (
        <ul className={rows.list}>
          {list.map((one) => (
            <li key={one.id} className={styles.row}>
              <div className={styles.words}>
                <strong>{isolated(one.name)}</strong>
                <span>{t("ui-created-by", { name: one.made_by, when: moment(one.made_at) })}</span>
              </div>
              <PressButton free kind="quiet" onPress={() => revoke(one.id)}>
                {texts.revoke}
              </PressButton>
            </li>
          ))}
        </ul>
      )}
      {secret && (
        <div className={styles.link} role="status">
          <p>{texts.once}</p>
          <code>{secret}</code>
        </div>
      )}
      <div className={styles.line}>
        <TextField label={texts.label} placeholder={texts.placeholder} value={name} maxLength={60} onText={setName} />
        <PressButton free disabled={!name.trim()} onPress={create}>
          {texts.create}
        </PressButton>
      </div>
    </section>
  );
}
