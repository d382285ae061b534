// Writes src/messages/collected: a file a language with all texts, the client's, the station's and the
// drivers', which stand beside the code that uses them.

import { mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";

const FRONTEND = new URL("..", import.meta.url);
const TREES = ["src/", "../app/crenel/", "../hardware/crenel_hardware/"].map((tree) => new URL(tree, FRONTEND));
const COLLECTED = new URL("src/messages/collected/", FRONTEND);

const byLanguage = new Map();
for (const tree of TREES) {
  for (const file of readdirSync(tree, { recursive: true }).sort()) {
    const [, language] = /(?:^|[\\/])([a-z-]+)\.ftl$/.exec(file) ?? [];
    if (language)
      byLanguage.set(language, `${byLanguage.get(language) ?? ""}${readFileSync(new URL(file, tree), "utf8")}`);
  }
}
rmSync(COLLECTED, { recursive: true, force: true });
mkdirSync(COLLECTED);
for (const [language, texts] of byLanguage) writeFileSync(new URL(`${language}.txt`, COLLECTED), texts);
