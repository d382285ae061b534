// Writes src/api/wire.ts: the types of wire.schema.json, which the Python side is the source of.

import { readFileSync, writeFileSync } from "node:fs";

import { compile } from "json-schema-to-typescript";

const FOLDER = new URL("../src/api/", import.meta.url);

const schema = JSON.parse(readFileSync(new URL("wire.schema.json", FOLDER), "utf8"));
const text = await compile(schema, "Wire", {
  additionalProperties: false,
  bannerComment: "// Written by scripts/wire.mjs from wire.schema.json.",
  format: false,
});
writeFileSync(new URL("wire.ts", FOLDER), text);
