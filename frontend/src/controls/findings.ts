import type { Action, Finding } from "../api/wire";
import { mentions, type Text } from "../messages/text";
import { asSent } from "../state/localized";

/**
 * Findings that are not displayed elsewhere: a reason why an action is not possible is next to the
 * action, and others are in the texts given.
 */
export function newFindings(findings: Finding[], actions: Action[], elsewhere: Text[] = []): Finding[] {
  const reasons = actions.filter(({ enabled }) => !enabled).map((action) => asSent(action).why_not);
  const texts = [...reasons, ...elsewhere];
  return findings.filter((finding) => !texts.some((text) => text !== "" && mentions(text, asSent(finding).text)));
}
