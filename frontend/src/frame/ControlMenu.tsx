import { Popover } from "@mantine/core";
import { useState } from "react";
import { ROLES } from "../access/roles";
import { askForControl, releaseControl, signOut, takeControl } from "../api/session";
import type { Control, CurrentUser } from "../api/wire";
import look from "../controls/Control.module.css";
import { PressButton } from "../controls/PressButton";
import { TextField } from "../controls/TextField";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import { useLive } from "../state/store";
import styles from "./ControlMenu.module.css";
import { PasswordForm } from "./PasswordForm";

/** Who has control, in the same place on every page, with a menu to obtain it. */
export function ControlMenu() {
  const you = useLive((s) => s.session?.you ?? null);
  const control = useLive((s) => s.control);
  // users of the console's link have no password
  const guest = useLive((s) => s.session?.by_code ?? false);
  const [opened, setOpened] = useState(false);
  if (!you) return null;
  const holder = control?.holder ?? null;
  const whose = !holder ? "free" : holder.id === you.id ? "yours" : "theirs";
  const words = { free: t("ui-nobody"), yours: t("ui-you"), theirs: holder?.name ?? "" }[whose];
  return (
    <Popover opened={opened} onChange={setOpened} position="bottom-end" shadow="md" radius="md" trapFocus zIndex={310}>
      <Popover.Target>
        <button
          type="button"
          className={`${look.button} ${styles.pill}`}
          data-whose={whose}
          data-part="control"
          aria-label={t("ui-control-who", { who: words })}
          aria-haspopup="dialog"
          aria-expanded={opened}
          onClick={() => setOpened(!opened)}
        >
          <span className={styles.dot} aria-hidden="true" />
          <span className={styles.words}>
            <span className={styles.state}>{t("ui-control")}</span>
            <span className={styles.who}>{isolated(words)}</span>
          </span>
        </button>
      </Popover.Target>
      <Popover.Dropdown className={styles.menu} aria-label={t("ui-control-and-sign-in")}>
        <Whose you={you} control={control} whose={whose} />
        <hr className={styles.rule} />
        <p>
          {t("ui-you-are-signed-in-as")} <strong>{isolated(you.name)}</strong>,{" "}
          {you.kiosk ? t("ui-a-kiosk-display") : t(ROLES[you.role])}.
        </p>
        {!you.kiosk && !guest && !you.by_provider && <PasswordForm />}
        <PressButton free onPress={async () => void (await signOut())}>
          {t("ui-sign-out")}
        </PressButton>
      </Popover.Dropdown>
    </Popover>
  );
}

interface WhoseProps {
  you: CurrentUser;
  control: Control | null;
  whose: "free" | "yours" | "theirs";
}

function Whose({ you, control, whose }: WhoseProps) {
  const [reason, setReason] = useState("");
  const holder = control?.holder;
  if (you.kiosk || you.role === "viewer") {
    return (
      <p>
        {holder ? t("ui-has-control", { name: holder.name }) : t("ui-nobody-has-control")}{" "}
        {t("ui-your-account-can-only-view")}
      </p>
    );
  }
  if (whose === "free") return <p>{t("ui-nobody-control-first-act-takes")}</p>;
  if (whose === "yours") {
    return (
      <>
        <p>{t("ui-you-control-others-only-watch")}</p>
        <PressButton free onPress={async () => void (await releaseControl())}>
          {t("ui-release-control")}
        </PressButton>
      </>
    );
  }
  const same = holder?.name === you.name;
  const requested = control?.asked_by?.id === you.id;
  return (
    <>
      <p>
        {same ? t("ui-you-have-control-in-another-browser") : t("ui-has-control", { name: holder?.name ?? "" })}{" "}
        {t("ui-stop-and-laser-off-always-respond")}
      </p>
      {!same && (
        <PressButton free disabled={requested} onPress={async () => void (await askForControl())}>
          {requested ? t("ui-control-requested") : t("ui-request-control")}
        </PressButton>
      )}
      {!same && (
        <TextField
          label={t("ui-take-over-control-give-reason", { name: holder?.name ?? "" })}
          value={reason}
          maxLength={120}
          onText={setReason}
        />
      )}
      <PressButton free disabled={!same && !reason.trim()} onPress={async () => void (await takeControl(reason))}>
        {t("ui-take-over")}
      </PressButton>
    </>
  );
}
