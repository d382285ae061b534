// Writes src/messages/places.ts: the ids of the client's texts, each with the names of its places.

import { readdirSync, readFileSync, writeFileSync } from "node:fs";

import { FluentResource } from "@fluent/bundle";

const SOURCES = new URL("../src/", import.meta.url);

/** The variables in a part of a parsed message. */
function variables(part) {
  if (typeof part !== "object" || part === null) return [];
  if (Array.isArray(part)) return part.flatMap(variables);
  return part.type === "var" ? [part.name] : Object.values(part).flatMap(variables);
}

const files = readdirSync(SOURCES, { recursive: true }).filter((file) => file.endsWith("/en.ftl"));
const body = files.flatMap((file) => new FluentResource(readFileSync(new URL(file, SOURCES), "utf8")).body);
body.sort((a, b) => (a.id < b.id ? -1 : 1));
const lines = body.map(({ id, value }) => {
  const names = [...new Set(variables(value))].sort().map((name) => `"${name}"`);
  return `  "${id}": ${names.join(" | ") || "never"};`;
});
const text = `// Written by scripts/places.mjs from the files en.ftl.\nexport interface Places {\n${lines.join("\n")}\n}\n`;
writeFileSync(new URL("messages/places.ts", SOURCES), text);
