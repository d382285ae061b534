import { expect, test } from "vitest";

import { bodySchema, type OpenApi, routesByGroup, typeText } from "./openapi";

const ANSWER = { responses: { "200": {} } };

test("routes are grouped by the first part of their path", () => {
  const description: OpenApi = {
    info: { version: "1" },
    paths: {
      "/api/scan": { get: ANSWER },
      "/api/support.zip": { get: ANSWER },
      "/api/scan/start": { post: ANSWER },
      "/metrics": { get: ANSWER },
    },
  };
  const groups = [...routesByGroup(description)].map(([name, routes]) => [
    name,
    routes.map(({ method, path }) => `${method} ${path}`),
  ]);
  expect(groups).toEqual([
    ["scan", ["GET /api/scan", "POST /api/scan/start"]],
    ["support", ["GET /api/support.zip"]],
    ["/metrics", ["GET /metrics"]],
  ]);
});

test.each([
  [{ $ref: "#/components/schemas/Home" }, "Home"],
  [{ type: "array", items: { anyOf: [{ type: "number" }, { type: "null" }] } }, "(number | null)[]"],
  [{ type: "array", prefixItems: [{ type: "number" }, { type: "string" }] }, "[number, string]"],
  [{ enum: ["good", "bad"], type: "string" }, '"good" | "bad"'],
  [{ const: "beat", type: "string" }, '"beat"'],
  [{}, "any"],
])("a schema in one line: %j", (schema, text) => {
  expect(typeText(schema)).toBe(text);
});

test("an answer without a schema has no shape", () => {
  expect(bodySchema({ content: { "application/json": { schema: {} } } })).toBeNull();
  expect(bodySchema(undefined)).toBeNull();
});
