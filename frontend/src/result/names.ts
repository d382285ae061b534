const SIDES: Record<string, string> = { L: "left", R: "right" };

/** "crest:2:L:front" as the trade says it: "crest 3, front left". */
export function cornerWords(name: string): string {
  const [level = "", ...rest] = name.split(":");
  const number = /^\d+$/.test(rest[0] ?? "") ? ` ${Number(rest.shift()) + 1}` : "";
  const place = rest.map((part) => SIDES[part] ?? part).reverse();
  return place.length > 0 ? `${level}${number}, ${place.join(" ")}` : name;
}
