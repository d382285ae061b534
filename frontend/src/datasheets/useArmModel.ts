import { useEffect, useState } from "react";

import { readArmModel } from "../api/datasheetCommands";
import type { ArmModelView } from "../api/wire";
import { useSettled } from "../controls/useSettled";
import { useBarred } from "../state/control";

type Answers = Record<string, string>;

/** A text with the model of an arm, what was answered of it, and what the station makes of both. */
export function useArmModel() {
  const [text, setText] = useState("");
  const [answers, setAnswers] = useState<Answers>({});
  const [read, setRead] = useState<{ text: string; view: ArmModelView } | null>(null);
  const barred = useBarred();
  const settled = useSettled(text);
  useEffect(() => {
    let wanted = true;
    if (barred) return;
    readArmModel(settled, answers).then(
      (found) => {
        if (!wanted || !found) return;
        setRead((before) => {
          const refused = found.problem && before?.text === settled;
          return { text: settled, view: refused ? withQuestions(found, before.view, answers) : found };
        });
      },
      () => undefined, // the lost connection has its own banner
    );
    return () => {
      wanted = false;
    };
  }, [settled, answers, barred]);
  return {
    text,
    setText: (typed: string) => {
      setText(typed);
      setAnswers({});
    },
    answer: (key: string, value: string) => setAnswers({ ...answers, [key]: value }),
    view: read?.view ?? null,
  };
}

/** A refused answer can be changed: what was asked stays. */
function withQuestions(found: ArmModelView, before: ArmModelView, answers: Answers): ArmModelView {
  const questions = before.questions.map((one) => ({ ...one, answer: answers[one.key] ?? one.answer }));
  return { ...found, questions };
}
