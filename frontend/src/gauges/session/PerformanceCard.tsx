import { useState } from "react";

import { sendCommand } from "../../api/guideCommands";
import type { PerformanceView } from "../../api/wire";
import { newFindings } from "../../controls/findings";
import { PressButton } from "../../controls/PressButton";
import { SessionCard } from "../../flow/SessionCard";
import type { PlainId } from "../../messages/text";
import { t } from "../../state/language";
import { asSent } from "../../state/localized";
import { Verdict } from "../judgement/BigVerdict";
import styles from "./PerformanceCard.module.css";

const REASONS: { reason: string; label: PlainId }[] = [
  { reason: "moved", label: "ui-reason-moved" },
  { reason: "operating", label: "ui-reason-operating" },
  { reason: "device", label: "ui-reason-device" },
  { reason: "other", label: "ui-reason-other" },
];

/** What to do in this step of a performance test; leaving it asks for the reason. */
export function PerformanceCard({ view }: { view: PerformanceView }) {
  const { result } = view.picture;
  const [leaving, setLeaving] = useState(false);
  const leave = view.actions.find(({ name }) => name === "abandon");
  const asks = view.frozen && leave?.enabled;
  const repeats = (name: string, args: object) => name === "begin_scan" && Object.keys(args).length > 0;
  const actions = view.actions.filter(({ name, args }) => !(asks && name === "abandon") && !repeats(name, args));
  return (
    <SessionCard
      guide="performance"
      view={view}
      actions={asks && leaving ? [] : actions}
      number={result ? <Verdict result={result.result} text={result.text} /> : undefined}
      findings={newFindings(view.findings, view.actions, result ? [asSent(result).text] : [])}
    >
      {asks && (
        <div className={styles.leave}>
          {leaving && <p>{t("ui-why-is-the-test-cancelled")}</p>}
          {leaving &&
            REASONS.map(({ reason, label }) => (
              <PressButton key={reason} onPress={() => sendCommand("performance", "abandon", { reason })}>
                {t(label)}
              </PressButton>
            ))}
          <PressButton free kind="quiet" onPress={() => setLeaving(!leaving)}>
            {leaving ? t("ui-continue-the-test") : t("ui-cancel-the-test")}
          </PressButton>
        </div>
      )}
    </SessionCard>
  );
}
