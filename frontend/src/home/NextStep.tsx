import { PressButton } from "../parts/PressButton";
import { go, usePage } from "../state/router";
import { useLive } from "../state/store";

/** Leads on to what Home says comes next, from a page that is not it. */
export function NextStep() {
  const page = usePage();
  const next = useLive((s) => s.home?.next);
  if (!next || next.page === page) return null;
  return (
    <PressButton free onPress={() => go(next.page)}>
      Next: {next.label[0]?.toLowerCase()}
      {next.label.slice(1)}
    </PressButton>
  );
}
