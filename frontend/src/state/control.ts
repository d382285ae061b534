import { t } from "./language";
import { useLive } from "./store";

/** Why this browser may not act now; nothing where it may. */
export function useBarred(): string {
  const you = useLive((s) => s.session?.you ?? null);
  const holder = useLive((s) => s.control?.holder ?? null);
  if (!you) return "";
  if (you.wall) return t("A wall screen looks on.");
  if (you.role === "viewer") return t("You look on: acting takes an operator.");
  if (holder && holder.id !== you.id) return t("{name} has control.", { name: holder.name });
  return "";
}
