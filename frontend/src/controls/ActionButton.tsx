import { useState } from "react";

import type { Action } from "../api/wire";
import { SHORTCUTS } from "../guidance/shortcuts";
import { PressButton } from "./PressButton";
import { Question } from "./Question";

interface ActionButtonProps {
  action: Action;
  onAct: (action: Action) => Promise<void>;
  describedBy?: string | undefined;
}

/** One action. A large one has its own reason; one that asks first is less prominent. */
export function ActionButton({ action, onAct, describedBy }: ActionButtonProps) {
  const [asking, setAsking] = useState(false);
  const quiet = action.confirm ? "quiet" : "secondary";
  return (
    <>
      <PressButton
        kind={action.primary ? "primary" : quiet}
        disabled={!action.enabled}
        why={action.primary && !action.enabled ? action.why_not : ""}
        describedBy={describedBy}
        keys={action.name === "undo" ? SHORTCUTS.undo.keys : undefined}
        onPress={() => (action.confirm ? setAsking(true) : onAct(action))}
      >
        {action.label}
      </PressButton>
      {action.confirm && <Question action={action} opened={asking} onClose={() => setAsking(false)} onAct={onAct} />}
    </>
  );
}
