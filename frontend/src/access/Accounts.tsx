import { useState } from "react";

import { type Account, type Role, ROLES } from "../api/accessTypes";
import { addAccount, changeAccount, removeAccount } from "../api/session";
import { moment } from "../parts/format";
import { PressButton } from "../parts/PressButton";
import { Question } from "../parts/Question";
import { TextField } from "../parts/TextField";
import { useLive } from "../state/store";
import styles from "./Access.module.css";
import { useReread } from "./useReread";

/** Everybody's account, and a new one. */
export function Accounts() {
  const { list, reread } = useReread<Account>("/api/accounts");
  return (
    <section className={styles.section} aria-label="Accounts">
      <h1 className={styles.title}>Accounts</h1>
      <ul className={styles.list}>
        {list?.map((account) => (
          <AccountRow key={account.name} account={account} onChange={reread} />
        ))}
      </ul>
      <NewAccount onDone={reread} />
    </section>
  );
}

function AccountRow({ account, onChange }: { account: Account; onChange: () => Promise<void> }) {
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
    label: `Remove ${account.name}`,
    enabled: true,
    why_not: "",
    confirm: `${account.name} is signed out everywhere and cannot sign in any more. What they did stays in the log.`,
    primary: false,
  };
  return (
    <li className={styles.row}>
      <div className={styles.words}>
        <strong>
          {account.name}
          {own && " (you)"}
        </strong>
        <span>since {moment(account.made_at)}</span>
      </div>
      <RoleChoice role={account.role} disabled={own} onRole={(role) => change({ role })} name={account.name} />
      {!own && password === null && (
        <PressButton free onPress={() => setPassword("")}>
          New password
        </PressButton>
      )}
      {!own && (
        <PressButton free kind="quiet" onPress={() => setAsking(true)}>
          Remove
        </PressButton>
      )}
      {password !== null && (
        <div className={styles.line}>
          <TextField
            label={`New password of ${account.name}`}
            type="password"
            autoComplete="new-password"
            value={password}
            onText={setPassword}
          />
          <PressButton free onPress={() => change({ password })}>
            Set
          </PressButton>
          <PressButton free kind="quiet" onPress={() => setPassword(null)}>
            Leave it
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
      className={styles.role}
      aria-label={`What ${name || "the new account"} may do`}
      value={role}
      disabled={disabled}
      onChange={(event) => onRole(event.target.value as Role)}
    >
      {(Object.keys(ROLES) as Role[]).map((one) => (
        <option key={one} value={one}>
          {ROLES[one]}
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
      <TextField label="New account" placeholder="Name" autoComplete="off" value={name} onText={setName} />
      <TextField
        label="Its first password"
        placeholder="10 characters or more"
        type="password"
        autoComplete="new-password"
        value={password}
        onText={setPassword}
      />
      <RoleChoice name={name} role={role} onRole={setRole} />
      <PressButton free disabled={!name.trim() || !password} onPress={add}>
        Add
      </PressButton>
    </div>
  );
}
