import { defineConfig } from "vitest/config";

export default defineConfig({
  // one page for all: making it takes longer than the tests
  test: { environment: "happy-dom", include: ["src/**/*.test.ts"], isolate: false, maxWorkers: 1 },
  server: { fs: { allow: [".", "../app/crenel/messages"] } },
});
