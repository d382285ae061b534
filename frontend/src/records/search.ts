/** Whether each word of a search is in one of the texts; any case, and without accents. */
export function matches(search: string, texts: readonly string[]): boolean {
  const all = plain(texts.join("\n"));
  return plain(search)
    .split(/\s+/)
    .every((word) => all.includes(word));
}

function plain(text: string): string {
  return text.normalize("NFKD").replace(/\p{M}/gu, "").toLowerCase();
}
