import { useState } from "react";

import { changePassword } from "../api/session";
import { PressButton } from "../controls/PressButton";
import { TextField } from "../controls/TextField";
import { notify } from "../state/banner";
import { t } from "../state/language";

/** Changes the user's own password; a press opens the form. */
export function PasswordForm() {
  const [opened, setOpened] = useState(false);
  const [old, setOld] = useState("");
  const [fresh, setFresh] = useState("");
  if (!opened) {
    return (
      <PressButton free onPress={() => setOpened(true)}>
        {t("ui-change-the-password")}
      </PressButton>
    );
  }
  const send = async () => {
    if (!(await changePassword(old, fresh))) return;
    setOpened(false);
    notify({ quality: "good", title: t("ui-password-changed-other-browsers-signed-out") }, 6000);
  };
  return (
    <>
      <TextField
        label={t("ui-old-password")}
        type="password"
        autoComplete="current-password"
        value={old}
        onText={setOld}
      />
      <TextField
        label={t("ui-new-password")}
        type="password"
        autoComplete="new-password"
        help={t("ui-at-least-10-characters-sentence")}
        value={fresh}
        onText={setFresh}
      />
      <PressButton free onPress={send}>
        {t("ui-change-password")}
      </PressButton>
    </>
  );
}
