import { type FormEvent, type ReactNode, useState } from "react";
import { enterByCode, makeAdmin, signIn, signInWithProvider } from "../api/session";
import type { SignInState } from "../api/wire";
import { ChooseLanguage } from "../controls/ChooseLanguage";
import { Mark } from "../controls/icons";
import rows from "../controls/List.module.css";
import { PressButton } from "../controls/PressButton";
import { QualityMark } from "../controls/QualityMark";
import { TextField } from "../controls/TextField";
import { ProxyBanner, useMissing } from "../frame/ProxyBanner";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import { useLive } from "../state/store";
import styles from "./EntrancePage.module.css";

/** The page for users who are not signed in: one form for the way to sign in. */
export function EntrancePage({ session }: { session: SignInState }) {
  return (
    <Entrance session={session}>
      {session.provider && <p className={styles.or}>{t("ui-or-with-an-account-of-this-station")}</p>}
      <Way session={session} />
    </Entrance>
  );
}

/** The sign-in with a provider, if there is one, above other ways. */
export function Entrance({ session, children }: { session: SignInState; children: ReactNode }) {
  const missing = useMissing();
  return (
    <main className={styles.page}>
      <div className={styles.card}>
        <div className={styles.brand}>
          <Mark />
          <div>
            <div className={styles.name}>Crenel</div>
            <div className={styles.station}>{isolated(session.station)}</div>
          </div>
        </div>
        {session.provider && <WithProvider session={session} />}
        {missing && <ProxyBanner missing={missing} />}
        {children}
        <EntranceMessage />
        <ChooseLanguage id="entrance-language" />
      </div>
    </main>
  );
}

/** The button for accounts of the provider, and why it cannot be used now. */
function WithProvider({ session }: { session: SignInState }) {
  return (
    <div className={styles.form}>
      <PressButton free kind="primary" onPress={async () => void (await signInWithProvider())}>
        {t("ui-sign-in-with-provider", { name: session.provider })}
      </PressButton>
      {session.provider_trouble && (
        <p className={styles.trouble}>
          <QualityMark quality="attention" />
          <span>{t("ui-provider-trouble", { trouble: String(session.provider_trouble) })}</span>
        </p>
      )}
    </div>
  );
}

/** The form for the way to sign in; a demonstration accepts its code and accounts. */
function Way({ session }: { session: SignInState }) {
  const [byName, setByName] = useState(!session.by_code);
  if (session.first_start) return <FirstAdmin />;
  if (!session.by_code) return <SignIn />;
  return (
    <>
      {byName ? <SignIn /> : <ByCode />}
      <PressButton free kind="quiet" onPress={() => setByName(!byName)}>
        {byName ? t("ui-sign-in-with-the-consoles-code") : t("ui-sign-in-with-a-name")}
      </PressButton>
    </>
  );
}

/** The error of the last attempt. */
function EntranceMessage() {
  const banner = useLive((s) => s.banner);
  if (!banner) return null;
  return (
    <div className={styles.banner} role="alert">
      <QualityMark quality={banner.quality} />
      <div>
        <strong>{banner.title}</strong>
        {banner.remedy && <div>{banner.remedy}.</div>}
      </div>
    </div>
  );
}

interface FormProps {
  title: string;
  text: string;
  act: string;
  onAct: () => Promise<unknown>;
  children: ReactNode;
}

function Form({ title, text, act, onAct, children }: FormProps) {
  const [busy, setBusy] = useState(false);
  const send = async () => {
    if (busy) return;
    setBusy(true);
    await onAct();
    setBusy(false);
  };
  const submit = (event: FormEvent) => {
    event.preventDefault();
    void send();
  };
  return (
    <form className={styles.form} onSubmit={submit}>
      <h1 className={rows.heading}>{title}</h1>
      <p className={styles.text}>{text}</p>
      {children}
      <PressButton free kind="primary" onPress={send}>
        {act}
      </PressButton>
      {/* so that Enter in a field sends the form */}
      <button type="submit" hidden />
    </form>
  );
}

function SignIn() {
  const [name, setName] = useState("");
  const [password, setPassword] = useState("");
  return (
    <Form
      title={t("ui-sign-in")}
      text={t("ui-viewers-account-watch-everything-operators-account")}
      act={t("ui-sign-in")}
      onAct={() => signIn(name, password)}
    >
      <TextField label={t("ui-name")} autoComplete="username" autoFocus value={name} onText={setName} />
      <TextField
        label={t("ui-password")}
        type="password"
        autoComplete="current-password"
        value={password}
        onText={setPassword}
      />
    </Form>
  );
}

function ByCode() {
  const [code, setCode] = useState("");
  return (
    <Form
      title={t("ui-open-the-station-by-its-link")}
      text={t("ui-console-runs-crenel-displays-link-open")}
      act={t("ui-sign-in")}
      onAct={() => enterByCode(code)}
    >
      <TextField
        label={t("ui-code")}
        autoComplete="off"
        autoCapitalize="characters"
        autoFocus
        value={code}
        onText={setCode}
      />
    </Form>
  );
}

function FirstAdmin() {
  const [code, setCode] = useState("");
  const [name, setName] = useState("");
  const [password, setPassword] = useState("");
  return (
    <Form
      title={t("ui-create-the-administrators-account")}
      text={t("ui-station-new-no-accounts-yet-console")}
      act={t("ui-create-account")}
      onAct={() => makeAdmin(code, name, password)}
    >
      <TextField
        label={t("ui-code-on-the-console")}
        autoComplete="off"
        autoCapitalize="characters"
        autoFocus
        value={code}
        onText={setCode}
      />
      <TextField label={t("ui-your-name")} autoComplete="username" value={name} onText={setName} />
      <TextField
        label={t("ui-password")}
        type="password"
        autoComplete="new-password"
        help={t("ui-least-10-characters-three-unrelated-words")}
        value={password}
        onText={setPassword}
      />
    </Form>
  );
}
