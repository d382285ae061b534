import { addKioskLink, removeKioskLink } from "../api/session";
import { t } from "../state/language";
import styles from "./Access.module.css";
import { AccessTokens } from "./AccessTokens";

/** Links for kiosk screens, which show everything and allow no action. */
export function KioskLinks() {
  return (
    <AccessTokens
      path="/api/kiosk-links"
      title={t("ui-kiosk-links")}
      intro={(count) => count === 0 && <p className={styles.text}>{t("ui-link-screen-shop-floor-gives-full")}</p>}
      add={addKioskLink}
      remove={removeKioskLink}
      texts={{
        revoke: t("ui-revoke-this-link"),
        once: t("ui-open-address-screen-appears-only-once"),
        label: t("ui-new-link"),
        placeholder: t("ui-location-of-the-screen"),
        create: t("ui-create-link"),
      }}
    />
  );
}
