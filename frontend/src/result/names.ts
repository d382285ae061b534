import { t, words } from "../state/language";

const SIDES: Record<string, string> = {
  L: words("left"),
  R: words("right"),
  front: words("front"),
  back: words("back"),
};
const LEVELS: Record<string, string> = { crest: words("crest"), floor: words("floor") };

/** "crest:2:L:front" as the trade says it: "crest 3, front left"; a pose before it stays. */
export function cornerWords(name: string, say: (text: string) => string = t): string {
  const [, pose] = /^pose (\d+) /.exec(name) ?? [];
  if (pose) return `${say("pose")} ${pose}: ${cornerWords(name.slice(name.indexOf(pose) + pose.length + 1), say)}`;
  const [level = "", ...rest] = name.split(":");
  const number = /^\d+$/.test(rest[0] ?? "") ? ` ${Number(rest.shift()) + 1}` : "";
  const place = rest.map((part) => say(SIDES[part] ?? part)).reverse();
  return place.length > 0 ? `${say(LEVELS[level] ?? level)}${number}, ${place.join(" ")}` : name;
}
