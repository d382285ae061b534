import { t } from "./language";
import { useLive } from "./store";

/** Why this browser may not act now; nothing if it may. */
export function useBarred(): string {
  const barred = useOnlyViews();
  const id = useLive((s) => s.session?.you?.id ?? null);
  const holder = useLive((s) => s.control?.holder ?? null);
  if (!barred && id !== null && holder && holder.id !== id) return t("ui-has-control", { name: holder.name });
  return barred;
}

/** Why this browser may only look, whoever has control; nothing if it may do more. */
export function useOnlyViews(): string {
  const known = useLive((s) => s.session !== null);
  const you = useLive((s) => s.session?.you ?? null);
  // what is pressed before the link has signed somebody in would be refused
  if (!known) return t("ui-waiting-for-the-station");
  if (!you) return "";
  if (you.kiosk) return t("ui-a-kiosk-display-can-only-view");
  if (you.role === "viewer") return t("ui-your-account-only-view-acting-requires");
  return "";
}
