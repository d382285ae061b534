import react from "@vitejs/plugin-react";
import { defineConfig } from "vite";

const station = "http://127.0.0.1:8000";

export default defineConfig({
  plugins: [react()],
  base: "/",
  build: {
    outDir: "../app/static",
    emptyOutDir: true,
    target: "es2022",
    license: { fileName: "licences.md" },
    chunkSizeWarningLimit: 600,
    // the client, and the page that is there while the station starts
    rollupOptions: { input: ["index.html", "starting.html"] },
  },
  server: {
    fs: { allow: [".", "../app/strings"] },
    proxy: {
      "/api": { target: station, ws: true },
      "/viewer": { target: station, ws: true },
    },
  },
});
