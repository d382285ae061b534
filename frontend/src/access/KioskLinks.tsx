import { useState } from "react";
import { addKioskLink, removeKioskLink } from "../api/session";
import type { KioskLinkSummary } from "../api/wire";
import { moment } from "../parts/format";
import rows from "../parts/List.module.css";
import { PressButton } from "../parts/PressButton";
import { TextField } from "../parts/TextField";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import styles from "./Access.module.css";
import { useReread } from "./useReread";

/** Links for kiosk displays, which give a full view and allow no action. */
export function KioskLinks() {
  const { list, reread } = useReread<KioskLinkSummary>("/api/kiosk-links");
  const [name, setName] = useState("");
  const [address, setAddress] = useState("");
  const add = async () => {
    const made = await addKioskLink(name);
    if (!made) return;
    setAddress(made);
    setName("");
    await reread();
  };
  const remove = async (id: string) => {
    await removeKioskLink(id);
    setAddress("");
    await reread();
  };
  return (
    <section className={styles.section} aria-label={t("ui-kiosk-links")}>
      <h2 className={styles.title}>{t("ui-kiosk-links")}</h2>
      {list?.length === 0 && <p className={styles.text}>{t("ui-link-screen-shop-floor-gives-full")}</p>}
      {list && list.length > 0 && (
        <ul className={rows.list}>
          {list.map((link) => (
            <li key={link.id} className={styles.row}>
              <div className={styles.words}>
                <strong>{isolated(link.name)}</strong>
                <span>{t("ui-created-by", { name: link.made_by, when: moment(link.made_at) })}</span>
              </div>
              <PressButton free kind="quiet" onPress={() => remove(link.id)}>
                {t("ui-revoke-this-link")}
              </PressButton>
            </li>
          ))}
        </ul>
      )}
      {address && (
        <div className={styles.link} role="status">
          <p>{t("ui-open-address-screen-appears-only-once")}</p>
          <code>{address}</code>
        </div>
      )}
      <div className={styles.line}>
        <TextField
          label={t("ui-new-link")}
          placeholder={t("ui-location-of-the-screen")}
          value={name}
          maxLength={60}
          onText={setName}
        />
        <PressButton free disabled={!name.trim()} onPress={add}>
          {t("ui-create-link")}
        </PressButton>
      </div>
    </section>
  );
}
