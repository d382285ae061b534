import { Modal } from "@mantine/core";

import { PressButton } from "../controls/PressButton";
import { t } from "../state/language";
import { go } from "../state/router";
import styles from "./HelpDialog.module.css";
import { showHelp, useHelp } from "./help";
import { SHORTCUTS } from "./shortcuts";
import { startTour } from "./tour";

/** The keys that act, and the tour. */
export function HelpDialog() {
  const opened = useHelp();
  const close = () => showHelp(false);
  const title = t("ui-keyboard-and-tour");
  return (
    <Modal
      opened={opened}
      onClose={close}
      withCloseButton={false}
      centered
      radius="md"
      size="md"
      attributes={{ content: { "aria-label": title } }}
    >
      <h2 className={styles.title}>{title}</h2>
      <dl className={styles.keys}>
        {Object.values(SHORTCUTS).map(({ keys, what }) => (
          <div key={keys}>
            <dt>
              <kbd>{words(keys)}</kbd>
            </dt>
            <dd>{t(what)}</dd>
          </div>
        ))}
      </dl>
      <p className={styles.note}>{t("ui-keys-note")}</p>
      <div className={styles.acts}>
        <PressButton
          free
          onPress={() => {
            close();
            startTour();
            go("home");
          }}
        >
          {t("ui-show-the-tour")}
        </PressButton>
        <PressButton free kind="quiet" onPress={close}>
          {t("ui-close")}
        </PressButton>
      </div>
    </Modal>
  );
}

const SIGNS: Record<string, string> = { ArrowUp: "↑", ArrowDown: "↓", ArrowLeft: "←", ArrowRight: "→" };

function words(keys: string): string {
  const named = keys.split("+").map((key) => {
    if (key === "Control") return t("ui-key-control");
    return SIGNS[key] ?? (key === "Enter" ? t("ui-key-enter") : key.toUpperCase());
  });
  return named.join(" + ");
}
