import { afterEach, beforeEach, expect, test, vi } from "vitest";

import type { ScanStatus } from "../api/wire";
import { setState } from "./store";
import { startWakeLock } from "./wakeLock";

let held = 0;
let visibility: DocumentVisibilityState = "visible";

class Sentinel extends EventTarget {
  async release(): Promise<void> {
    held -= 1;
    this.dispatchEvent(new Event("release"));
  }
}

const taken: Sentinel[] = [];

async function request(): Promise<Sentinel> {
  held += 1;
  const sentinel = new Sentinel();
  taken.push(sentinel);
  return sentinel;
}

const settled = () => new Promise((resolve) => setTimeout(resolve, 0));

async function scan(state: ScanStatus["state"]): Promise<void> {
  setState({ scan: { state } as ScanStatus });
  await settled();
}

async function show(state: DocumentVisibilityState): Promise<void> {
  visibility = state;
  document.dispatchEvent(new Event("visibilitychange"));
  await settled();
}

beforeEach(() => {
  vi.spyOn(document, "visibilityState", "get").mockImplementation(() => visibility);
  Object.defineProperty(navigator, "wakeLock", { value: { request }, configurable: true });
});

afterEach(() => {
  setState({ scan: null });
  Reflect.deleteProperty(navigator, "wakeLock");
  vi.restoreAllMocks();
});

test("the screen stays on during a scan, and again when the page is shown again", async () => {
  startWakeLock();
  await scan("idle");
  expect(held).toBe(0);
  await scan("running");
  await scan("running");
  expect(held).toBe(1);
  // the browser takes it from a hidden page
  await taken.at(-1)?.release();
  await show("hidden");
  expect(held).toBe(0);
  await show("visible");
  expect(held).toBe(1);
  await scan("stopping");
  expect(held).toBe(0);
  setState({ scan: { state: "running" } as ScanStatus });
  setState({ scan: { state: "idle" } as ScanStatus });
  await settled();
  await settled();
  expect(held).toBe(0);
});
