import { useState } from "react";

import type { Wall } from "../api/accessTypes";
import { addWall, removeWall } from "../api/session";
import rows from "../parts/List.module.css";
import { moment } from "../parts/format";
import { PressButton } from "../parts/PressButton";
import { TextField } from "../parts/TextField";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import styles from "./Access.module.css";
import { useReread } from "./useReread";

/** Links for screens on a wall, which show everything and let nobody do anything. */
export function Walls() {
  const { list, reread } = useReread<Wall>("/api/walls");
  const [name, setName] = useState("");
  const [address, setAddress] = useState("");
  const add = async () => {
    const made = await addWall(name);
    if (!made) return;
    setAddress(made);
    setName("");
    await reread();
  };
  const remove = async (id: string) => {
    await removeWall(id);
    setAddress("");
    await reread();
  };
  return (
    <section className={styles.section} aria-label={t("Wall screens")}>
      <h2 className={styles.title}>{t("Wall screens")}</h2>
      {list?.length === 0 && (
        <p className={styles.text}>{t("A link for a screen in the hall: it shows everything, and nobody can act there.")}</p>
      )}
      {list && list.length > 0 && (
        <ul className={rows.list}>
          {list.map((wall) => (
            <li key={wall.id} className={styles.row}>
              <div className={styles.words}>
                <strong>{isolated(wall.name)}</strong>
                <span>
                  {t("made by {name}, {when}", { name: wall.made_by, when: moment(wall.made_at) })}
                </span>
              </div>
              <PressButton free kind="quiet" onPress={() => remove(wall.id)}>
                {t("End this link")}
              </PressButton>
            </li>
          ))}
        </ul>
      )}
      {address && (
        <div className={styles.link} role="status">
          <p>{t("Open this at the screen. It is shown this once:")}</p>
          <code>{address}</code>
        </div>
      )}
      <div className={styles.line}>
        <TextField label={t("New link")} placeholder={t("Where the screen hangs")} value={name} maxLength={60} onText={setName} />
        <PressButton free disabled={!name.trim()} onPress={add}>
          {t("Make a link")}
        </PressButton>
      </div>
    </section>
  );
}
