import type { Action, Finding } from "../api/types";

/** Findings beyond what is said already: why an act is not possible stands at the act itself. */
export function withoutEchoes(findings: Finding[], actions: Action[], said: (text: string) => boolean = () => false): Finding[] {
  const reasons = new Set(actions.filter(({ enabled }) => !enabled).map(({ why_not }) => why_not));
  return findings.filter(({ text }) => !reasons.has(text) && !said(text));
}
