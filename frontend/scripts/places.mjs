// Writes src/messages/places.ts: the ids of the client's texts, each with the names of its places.

import { readFileSync, writeFileSync } from "node:fs";

import { FluentResource } from "@fluent/bundle";

const FOLDER = new URL("../src/messages/", import.meta.url);

/** The variables in a part of a parsed message. */
function variables(part) {
  if (typeof part !== "object" || part === null) return [];
  if (Array.isArray(part)) return part.flatMap(variables);
  return part.type === "var" ? [part.name] : Object.values(part).flatMap(variables);
}

const { body } = new FluentResource(readFileSync(new URL("en.ftl", FOLDER), "utf8"));
const lines = body.map(({ id, value }) => {
  const names = [...new Set(variables(value))].sort().map((name) => `"${name}"`);
  return `  "${id}": ${names.join(" | ") || "never"};`;
});
const text = `// Written by scripts/places.mjs from en.ftl.\nexport interface Places {\n${lines.join("\n")}\n}\n`;
writeFileSync(new URL("places.ts", FOLDER), text);
