import type { Action } from "../api/wire";
import { Question } from "../controls/Question";
import { t } from "../state/language";
import { useLive } from "../state/store";
import { activityWords } from "./activityWords";

/** Before an activity takes the arm from another one, on every page. */
export function ArmQuestion() {
  const question = useLive((s) => s.armQuestion);
  if (!question) return null;
  const action: Action = {
    name: "end-activity",
    label: t("ui-end-it-and-go-on"),
    confirm: t("ui-arm-is-in-use-end-it", { activity: activityWords(question.activity) }),
    enabled: true,
    why_not: "",
    primary: true,
    args: {},
  };
  return (
    <Question
      opened
      free
      action={action}
      no={t("ui-no-keep-it")}
      onClose={() => question.answer(false)}
      onAct={async () => question.answer(true)}
    />
  );
}
