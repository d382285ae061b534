import styles from "../access/Access.module.css";
import { AccessTokens } from "../access/AccessTokens";
import { addMetricsToken, removeMetricsToken } from "../api/watchCommands";
import { addressOf, BASE } from "../state/base";
import { t } from "../state/language";

/** Tokens by which programs read the metrics. */
export function MetricsTokens() {
  const address = new URL(addressOf("/metrics"), BASE).href;
  return (
    <AccessTokens
      path="/api/tokens"
      title={t("ui-metrics")}
      intro={() => <p className={styles.text}>{t("ui-prometheus-reads", { address })}</p>}
      add={addMetricsToken}
      remove={removeMetricsToken}
      texts={{
        revoke: t("ui-revoke-this-token"),
        once: t("ui-enter-program-appears-only-once"),
        label: t("ui-new-token"),
        placeholder: t("ui-name-of-the-program"),
        create: t("ui-create-token"),
      }}
    />
  );
}
