import { useState } from "react";
import { addAccount, changeAccount, removeAccount } from "../api/session";
import type { Role } from "../api/types";
import type { AccountSummary } from "../api/wire";
import look from "../controls/Control.module.css";
import { moment } from "../controls/format";
import rows from "../controls/List.module.css";
import { PressButton } from "../controls/PressButton";
import { Question } from "../controls/Question";
import { TextField } from "../controls/TextField";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import { useLive } from "../state/store";
import styles from "./Access.module.css";
import { ROLES } from "./roles";
import { useReread } from "./useReread";

/** All accounts, and a form for a new one. */
export function Accounts() {
  const { list, reread } = useReread<AccountSummary>("/api/accounts");
  return (
    <section className={styles.section} aria-label={t("ui-accounts")}>
      <h1 className={rows.heading}>{t("ui-accounts")}</h1>
      <ul className={rows.list}>
        {list?.map((account) => (
          <AccountRow key={account.name} account={account} onChange={reread} />
        ))}
      </ul>
      <NewAccount onDone={reread} />
    </section>
  );
}

function AccountRow({ account, onChange }: { account: AccountSummary; onChange: () => Promise<void> }) {
  const own = useLive((s) => s.session?.you?.name === account.name);
  const [asking, setAsking] = useState(false);
  const [password, setPassword] = useState<string | null>(null);
  const change = async (what: { role?: Role; password?: string }) => {
    if (await changeAccount(account.name, what)) setPassword(null);
    await onChange();
  };
  const remove = async () => {
    await removeAccount(account.name);
    await onChange();
  };
  const act = {
    name: "remove",
    args: {},
    label: t("ui-remove-name", { name: account.name }),
    enabled: true,
    why_not: "",
    confirm: t("ui-signed-out-everywhere-no-longer-sign", { name: account.name }),
    primary: false,
  };
  return (
    <li className={styles.row}>
      <div className={styles.words}>
        <strong>
          {isolated(account.name)}
          {own && ` (${t("ui-you")})`}
        </strong>
        <span>{t("ui-since", { when: moment(account.made_at) })}</span>
        {account.by_provider && <span>{t("ui-provider-sets-role-and-password")}</span>}
      </div>
      {account.by_provider ? (
        <span>{t(ROLES[account.role])}</span>
      ) : (
        <RoleChoice role={account.role} disabled={own} onRole={(role) => change({ role })} name={account.name} />
      )}
      {!own && !account.by_provider && password === null && (
        <PressButton free onPress={() => setPassword("")}>
          {t("ui-new-password")}
        </PressButton>
      )}
      {!own && (
        <PressButton free kind="quiet" onPress={() => setAsking(true)}>
          {t("ui-remove")}
        </PressButton>
      )}
      {password !== null && (
        <div className={styles.line}>
          <TextField
            label={t("ui-new-password-of", { name: account.name })}
            type="password"
            autoComplete="new-password"
            value={password}
            onText={setPassword}
          />
          <PressButton free onPress={() => change({ password })}>
            {t("ui-set")}
          </PressButton>
          <PressButton free kind="quiet" onPress={() => setPassword(null)}>
            {t("ui-cancel")}
          </PressButton>
        </div>
      )}
      <Question free action={act} opened={asking} onClose={() => setAsking(false)} onAct={remove} />
    </li>
  );
}

interface RoleChoiceProps {
  name: string;
  role: Role;
  disabled?: boolean;
  onRole: (role: Role) => void;
}

function RoleChoice({ name, role, disabled = false, onRole }: RoleChoiceProps) {
  return (
    <select
      className={look.input}
      aria-label={t("ui-role-of", { name: name || t("ui-role-of-the-new-account") })}
      value={role}
      disabled={disabled}
      onChange={(event) => onRole(event.target.value as Role)}
    >
      {(Object.keys(ROLES) as Role[]).map((one) => (
        <option key={one} value={one}>
          {t(ROLES[one])}
        </option>
      ))}
    </select>
  );
}

function NewAccount({ onDone }: { onDone: () => Promise<void> }) {
  const [name, setName] = useState("");
  const [password, setPassword] = useState("");
  const [role, setRole] = useState<Role>("operator");
  const add = async () => {
    if (!(await addAccount(name, role, password))) return;
    setName("");
    setPassword("");
    await onDone();
  };
  return (
    <div className={styles.line}>
      <TextField
        label={t("ui-new-account")}
        placeholder={t("ui-name")}
        autoComplete="off"
        value={name}
        onText={setName}
      />
      <TextField
        label={t("ui-initial-password")}
        placeholder={t("ui-at-least-10-characters")}
        type="password"
        autoComplete="new-password"
        value={password}
        onText={setPassword}
      />
      <RoleChoice name={name} role={role} onRole={setRole} />
      <PressButton free disabled={!name.trim() || !password} onPress={add}>
        {t("ui-add")}
      </PressButton>
    </div>
  );
}
