import { useCallback, useEffect, useState } from "react";

import { get } from "../api/http";
import { changeNotifications, readNotifications, tryNotifications } from "../api/watchCommands";
import type { Notifications as NotificationSettings } from "../api/wire";
import rows from "../controls/List.module.css";
import { PressButton } from "../controls/PressButton";
import { QualityMark } from "../controls/QualityMark";
import { TextField } from "../controls/TextField";
import { t } from "../state/language";
import { askForNotifications, stopNotifications, useNotificationState } from "../state/notifications";
import styles from "./Health.module.css";

const KINDS = [
  { kind: "done", label: "ui-done-scan-saved-calibration-accepted" },
  { kind: "fault", label: "ui-fault-device-lost-recording-failed" },
  { kind: "due", label: "ui-due-a-calibration-is-too-old" },
] as const;

/** Notifications of finished jobs, faults and due checks. */
export function Notifications({ admin }: { admin: boolean }) {
  return (
    <section className={styles.section} aria-label={t("ui-notifications")}>
      <h2 className={rows.heading}>{t("ui-notifications")}</h2>
      <div className={styles.box}>
        <h3>{t("ui-in-this-browser")}</h3>
        <InBrowser />
      </div>
      {admin && (
        <div className={styles.box}>
          <h3>{t("ui-by-webhook")}</h3>
          <ByWebhook />
        </div>
      )}
    </section>
  );
}

function InBrowser() {
  const state = useNotificationState();
  if (state === "impossible") {
    return <p className={styles.help}>{t("ui-browser-displays-notifications-only-over-https")}</p>;
  }
  if (state === "denied") {
    return <p className={styles.help}>{t("ui-notifications-blocked-browser-allow-them-icon")}</p>;
  }
  return (
    <>
      <p>{t("ui-completed-jobs-faults-due-calibrations-also")}</p>
      <div className={styles.row}>
        {state === "on" ? (
          <PressButton free onPress={stopNotifications}>
            {t("ui-turn-off-notifications-here")}
          </PressButton>
        ) : (
          <PressButton free onPress={askForNotifications}>
            {t("ui-turn-on-notifications-here")}
          </PressButton>
        )}
      </div>
    </>
  );
}

function ByWebhook() {
  const [current, setCurrent] = useState<NotificationSettings | null>(null);
  const [url, setUrl] = useState("");
  const [secret, setSecret] = useState("");
  const put = useCallback((now: NotificationSettings | null) => {
    if (!now) return;
    setCurrent(now);
    setUrl(now.url);
    setSecret("");
  }, []);
  useEffect(() => void get<NotificationSettings>("/api/notifications").then(put, () => undefined), [put]);
  if (!current) return <p className={styles.help}>{t("ui-loading")}</p>;
  const save = async (change: Partial<NotificationSettings>) => {
    const { done, fault, due } = { ...current, ...change };
    put(await changeNotifications({ url, secret: secret || null, done, fault, due }));
  };
  const tryOut = async () => {
    if (!(await tryNotifications())) return;
    await new Promise((resolve) => setTimeout(resolve, 1500));
    put(await readNotifications());
  };
  return (
    <>
      <p className={styles.help}>{t("ui-notification-sent-json-post-signed-hmac")}</p>
      <TextField
        label={t("ui-address")}
        placeholder="https://"
        inputMode="url"
        autoComplete="off"
        value={url}
        onText={setUrl}
      />
      <TextField
        label={t("ui-secret")}
        type="password"
        autoComplete="new-password"
        placeholder={current.has_secret ? t("ui-set-it-is-not-displayed-again") : t("ui-none")}
        help={t("ui-new-address-requires-secret-again")}
        value={secret}
        onText={setSecret}
      />
      <div className={styles.switches}>
        {KINDS.map(({ kind, label }) => (
          <label key={kind} className={styles.switch}>
            <input
              type="checkbox"
              checked={current[kind]}
              onChange={(event) => void save({ [kind]: event.target.checked })}
            />
            {t(label)}
          </label>
        ))}
      </div>
      <div className={styles.row}>
        <PressButton free disabled={url === current.url && !secret} onPress={() => save({})}>
          {t("ui-set")}
        </PressButton>
        <PressButton free disabled={!current.url} onPress={tryOut}>
          {t("ui-test")}
        </PressButton>
        {current.url && <Deliveries current={current} />}
      </div>
    </>
  );
}

function Deliveries({ current }: { current: NotificationSettings }) {
  const fared = current.trouble
    ? t("ui-not-delivered", { reason: current.trouble })
    : current.sent
      ? t("ui-messages-delivered", { n: current.sent })
      : t("ui-nothing-sent-yet");
  return (
    <p className={styles.fared} role="status">
      <QualityMark quality={current.trouble ? "attention" : current.sent ? "good" : "neutral"} size="1.25rem" />
      {fared}
      {current.waiting > 0 && `, ${t("ui-n-waiting", { n: current.waiting })}`}
    </p>
  );
}
