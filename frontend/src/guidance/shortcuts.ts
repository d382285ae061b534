import type { PlainId } from "../messages/text";
import { showHelp } from "./help";

/** What a hand at the keyboard repeats; barcode scanners and elbows press none of these. */
export const SHORTCUTS = {
  main: { keys: "Control+Enter", what: "ui-key-main" },
  undo: { keys: "Control+z", what: "ui-key-undo" },
  stop: { keys: "Control+.", what: "ui-key-stop" },
  above: { keys: "Control+ArrowUp", what: "ui-key-above" },
  front: { keys: "Control+ArrowDown", what: "ui-key-front" },
  side: { keys: "Control+ArrowRight", what: "ui-key-side" },
  whole: { keys: "Control+ArrowLeft", what: "ui-key-whole" },
  help: { keys: "?", what: "ui-key-help" },
} as const satisfies Record<string, { keys: string; what: PlainId }>;

/** A pressed key as `aria-keyshortcuts` writes it; Command counts as Control. */
export function keysOf(event: Pick<KeyboardEvent, "key" | "ctrlKey" | "metaKey" | "altKey" | "shiftKey">): string {
  if (event.altKey) return "";
  if (!event.ctrlKey && !event.metaKey) return event.key;
  return event.shiftKey ? "" : `Control+${event.key.length === 1 ? event.key.toLowerCase() : event.key}`;
}

/** Presses the button that states a shortcut in `aria-keyshortcuts` when its keys are pressed; only
 *  Stop responds while something is typed or asked. */
export function startShortcuts(): void {
  const onKey = (event: KeyboardEvent) => {
    const keys = keysOf(event);
    const isKnown = Object.values(SHORTCUTS).some((shortcut) => shortcut.keys === keys);
    if (!isKnown || event.repeat) return;
    if (keys !== SHORTCUTS.stop.keys && (isTyping(event.target) || document.querySelector("[aria-modal=true]"))) return;
    if (keys === SHORTCUTS.help.keys) showHelp(true);
    const stating = document.querySelectorAll<HTMLElement>(`[aria-keyshortcuts="${keys}"]`);
    const button = Array.from(stating).find((one) => one.checkVisibility());
    if (!button) return;
    event.preventDefault();
    button.click();
  };
  window.addEventListener("keydown", onKey);
  // keys that are pressed in the 3D view do not come here by themselves
  window.addEventListener("blur", () => {
    const frame = document.activeElement;
    if (frame instanceof HTMLIFrameElement) frame.contentWindow?.addEventListener("keydown", onKey);
  });
}

function isTyping(target: EventTarget | null): boolean {
  const element = target as Partial<HTMLElement> | null;
  return element?.matches?.("input, textarea, select, [contenteditable=true]") ?? false;
}
