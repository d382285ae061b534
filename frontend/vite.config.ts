import react from "@vitejs/plugin-react";
import { defineConfig } from "vite";

const station = "http://127.0.0.1:8000";

export default defineConfig(({ command }) => ({
  plugins: [react()],
  // the station puts what is before them into the pages that it sends (app/crenel/api/static_files.py)
  base: command === "build" ? "./" : "/",
  build: {
    outDir: "../app/crenel/static",
    emptyOutDir: true,
    target: "es2022",
    license: { fileName: "licences.md" },
    chunkSizeWarningLimit: 600,
    rollupOptions: {
      // the client, the page that is there while the station starts, and that of the fleet
      input: ["index.html", "starting.html", "fleet.html"],
      // a language is one file, the client's texts and the station's
      output: {
        codeSplitting: {
          groups: [
            { test: /collected/, debugName: "texts", name: (id) => `texts-${/(\w+)\.txt/.exec(id)?.[1]}` },
            // what every page has is one file, whose styles come before those of the pages
            { test: /src\/(api|frame|guidance|messages|parts|state)\/[^?]*\.(ts|tsx|css)/, name: "common" },
          ],
        },
      },
    },
  },
  server: {
    fs: { allow: ["."] },
    proxy: {
      "/api": { target: station, ws: true },
      "/viewer": { target: station, ws: true },
    },
  },
}));
