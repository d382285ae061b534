import { defineConfig } from "vitest/config";

export default defineConfig({
  test: {
    environment: "happy-dom",
    include: ["src/**/*.test.ts"],
    // one page for all: making it takes longer than the tests
    isolate: false,
    maxWorkers: 1,
    testTimeout: 120_000, // of a busy machine
  },
  server: { fs: { allow: [".", "../app/crenel/messages"] } },
});
