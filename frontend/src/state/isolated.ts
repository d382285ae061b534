/** Names in any script within sentences in another. The Python counterpart is app/crenel/messages/isolated.py. */

const FIRST_STRONG = "\u2068";
const POP = "\u2069";
const LEFTWARDS = /[\u0590-\u08ff\u200f\ufb1d-\ufdff\ufe70-\ufefc\u{10800}-\u{10fff}\u{1e800}-\u{1efff}]/u;
/** Right-to-left letters with the characters between them. */
const RUN = new RegExp(`${LEFTWARDS.source}(?:[\\p{M}\\p{N} _'’-]*${LEFTWARDS.source})*`, "gu");
/** Characters that change the direction of the following text, except in text that was isolated before. */
const TURNING = /\u2068[^\u202a-\u202e\u2066-\u2069]*\u2069|[\u202a-\u202e\u2066-\u2069]/g;
const ANY =
  /[\u0590-\u08ff\u200f\u202a-\u202e\u2066-\u2069\ufb1d-\ufdff\ufe70-\ufefc\u{10800}-\u{10fff}\u{1e800}-\u{1efff}]/u;

/** A name: in any script, it does not disturb the adjacent text. */
export function isolated(name: string): string {
  if (!ANY.test(name)) return name;
  const plain = harmless(name);
  return plain.includes(FIRST_STRONG) ? plain : `${FIRST_STRONG}${plain}${POP}`;
}

/** A sentence with such names in it. */
export function withIsolated(sentence: string): string {
  if (!ANY.test(sentence)) return sentence;
  const plain = harmless(sentence);
  return plain.includes(FIRST_STRONG) ? plain : plain.replace(RUN, (run) => `${FIRST_STRONG}${run}${POP}`);
}

/** Characters that change the text direction are replaced by a visible one. */
function harmless(text: string): string {
  return text.replace(TURNING, (found) => (found.length > 1 ? found : "\ufffd"));
}
