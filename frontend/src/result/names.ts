const SIDES: Record<string, string> = { L: "left", R: "right" };

/** "crest:2:L:front" as the trade says it: "crest 3, front left"; a pose before it stays. */
export function cornerWords(name: string): string {
  const pose = /^pose \d+ /.exec(name)?.[0];
  if (pose) return `${pose.trim()}: ${cornerWords(name.slice(pose.length))}`;
  const [level = "", ...rest] = name.split(":");
  const number = /^\d+$/.test(rest[0] ?? "") ? ` ${Number(rest.shift()) + 1}` : "";
  const place = rest.map((part) => SIDES[part] ?? part).reverse();
  return place.length > 0 ? `${level}${number}, ${place.join(" ")}` : name;
}
