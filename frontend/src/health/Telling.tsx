import { useEffect, useState } from "react";

import { get } from "../api/http";
import { changeNotifications, readNotifications, tryNotifications } from "../api/watchCommands";
import type { Notifications } from "../api/watchTypes";
import { PressButton } from "../parts/PressButton";
import { QualityMark } from "../parts/QualityMark";
import { TextField } from "../parts/TextField";
import { counted, t, words } from "../state/language";
import { askToTell, stopTelling, useTelling } from "../state/telling";
import styles from "./Health.module.css";

const KINDS = [
  { kind: "done", label: words("Done: a scan saved, a calibration accepted") },
  { kind: "fault", label: words("Fault: a device lost, a recording that failed") },
  { kind: "due", label: words("Due: a calibration that has come of age") },
] as const;

/** Who is told of what is done, at fault or due. */
export function Telling({ admin }: { admin: boolean }) {
  return (
    <section className={styles.section} aria-label={t("Notifications")}>
      <h2 className={styles.title}>{t("Notifications")}</h2>
      <div className={styles.box}>
        <h3>{t("In this browser")}</h3>
        <InBrowser />
      </div>
      {admin && (
        <div className={styles.box}>
          <h3>{t("By webhook")}</h3>
          <ByWebhook />
        </div>
      )}
    </section>
  );
}

function InBrowser() {
  const telling = useTelling();
  if (telling === "impossible") {
    return (
      <p className={styles.help}>
        {t("This browser shows notifications only over HTTPS, or on the station itself. Name tls_certificate and tls_key in station.toml.")}
      </p>
    );
  }
  if (telling === "denied") {
    return <p className={styles.help}>{t("This browser was told not to show notifications. Allow them by the sign beside the address.")}</p>;
  }
  return (
    <>
      <p>{t("What is done, at fault or due is shown here also while another window is in front.")}</p>
      <div className={styles.row}>
        {telling === "on" ? (
          <PressButton free onPress={stopTelling}>
            {t("Notify here no more")}
          </PressButton>
        ) : (
          <PressButton free onPress={askToTell}>
            {t("Notify me here")}
          </PressButton>
        )}
      </div>
    </>
  );
}

function ByWebhook() {
  const [held, setHeld] = useState<Notifications | null>(null);
  const [url, setUrl] = useState("");
  const [secret, setSecret] = useState("");
  const put = (now: Notifications | null) => {
    if (!now) return;
    setHeld(now);
    setUrl(now.url);
    setSecret("");
  };
  useEffect(() => void get<Notifications>("/api/notifications").then(put, () => undefined), []);
  if (!held) return <p className={styles.help}>{t("Reading.")}</p>;
  const save = async (change: Partial<Notifications>) => {
    const { done, fault, due } = { ...held, ...change };
    put(await changeNotifications({ url, secret: secret || null, done, fault, due }));
  };
  const tryOut = async () => {
    if (!(await tryNotifications())) return;
    await new Promise((resolve) => setTimeout(resolve, 1500));
    put(await readNotifications());
  };
  return (
    <>
      <p className={styles.help}>
        {t("Each is sent as JSON by POST, signed by HMAC-SHA256 in the header Crenel-Signature, and tried again where it is not taken.")}
      </p>
      <TextField label={t("Address")} placeholder="https://" inputMode="url" autoComplete="off" value={url} onText={setUrl} />
      <TextField
        label={t("Secret")}
        type="password"
        autoComplete="new-password"
        placeholder={held.has_secret ? t("there is one; it is not shown again") : t("none")}
        help={t("A new address needs its secret given anew.")}
        value={secret}
        onText={setSecret}
      />
      <div className={styles.switches}>
        {KINDS.map(({ kind, label }) => (
          <label key={kind} className={styles.switch}>
            <input type="checkbox" checked={held[kind]} onChange={(event) => void save({ [kind]: event.target.checked })} />
            {t(label)}
          </label>
        ))}
      </div>
      <div className={styles.row}>
        <PressButton free disabled={url === held.url && !secret} onPress={() => save({})}>
          {t("Set")}
        </PressButton>
        <PressButton free disabled={!held.url} onPress={tryOut}>
          {t("Try it")}
        </PressButton>
        {held.url && <Fared held={held} />}
      </div>
    </>
  );
}

function Fared({ held }: { held: Notifications }) {
  const fared = held.trouble ? t("Not taken: {reason}", { reason: held.trouble }) : held.sent ? counted(held.sent, "{n} message taken", "{n} messages taken") : t("Nothing sent yet");
  return (
    <p className={styles.fared} role="status">
      <QualityMark quality={held.trouble ? "attention" : held.sent ? "good" : "neutral"} size="1.25rem" />
      {fared}
      {held.waiting > 0 && `, ${t("{n} waiting", { n: held.waiting })}`}
    </p>
  );
}
