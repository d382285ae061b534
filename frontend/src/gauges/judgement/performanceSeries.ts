import type { PerformanceSymbols, SymbolValue } from "../../api/wire";
import type { PlainId } from "../../messages/text";
import { t } from "../../state/language";

/** The kinds of length standards, whose symbols are the same. */
const STANDARDS: Record<string, PlainId> = {
  "ball-bar": "ui-ball-bar",
  "step-gauge": "ui-step-gauge",
};

/** A test with the one symbol that is drawn. */
export type Point = PerformanceSymbols & { found: SymbolValue };

/** One symbol over the tests on one kind of artefact, at least two of them. */
export interface Series {
  key: string;
  symbol: string;
  signed: boolean;
  /** The symbol in words, of lengths with the kind of the standard. */
  label: string;
  /** The oldest first. */
  points: Point[];
}

/**
 * Every symbol that two tests or more have, with the arm of the newest test and on the same kind of
 * artefact; those of the newest test come first.
 *
 * @param tests the oldest first
 */
export function listSeries(tests: PerformanceSymbols[]): Series[] {
  const arm = tests[tests.length - 1]?.arm_serial;
  const series = new Map<string, Series>();
  for (const test of tests.filter(({ arm_serial }) => arm_serial === arm).reverse())
    for (const found of test.symbols) {
      const key = `${test.artefact_kind}/${found.quantity}`;
      const known = series.get(key);
      if (known) known.points.unshift({ ...test, found });
      else {
        const { symbol, signed, title } = found;
        const kind = STANDARDS[test.artefact_kind];
        const label = [symbol, title, kind && t(kind)].filter(Boolean).join(" · ");
        series.set(key, { key, symbol, signed, label, points: [{ ...test, found }] });
      }
    }
  return [...series.values()].filter(({ points }) => points.length > 1);
}
