// Writes each built file a second and a third time, compressed for browsers: name.br and name.gz.

import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { brotliCompressSync, constants, gzipSync } from "node:zlib";

const FOLDER = new URL("../../app/crenel/static/assets/", import.meta.url);

for (const name of readdirSync(FOLDER).filter((file) => /\.(js|css)$/.test(file))) {
  const content = readFileSync(new URL(name, FOLDER));
  const params = { [constants.BROTLI_PARAM_SIZE_HINT]: content.length };
  writeFileSync(new URL(`${name}.br`, FOLDER), brotliCompressSync(content, { params }));
  writeFileSync(new URL(`${name}.gz`, FOLDER), gzipSync(content, { level: 9 }));
}
