import { getState, subscribe } from "./store";

let lock: WakeLockSentinel | null = null;
let asking = false;

function wants(): boolean {
  return getState().scan?.state === "running" && document.visibilityState === "visible";
}

/** Brings the lock in line with the scan; the browser takes it away from a hidden page. */
async function adjust(): Promise<void> {
  if (asking || wants() === (lock !== null)) return;
  asking = true;
  try {
    if (lock) await lock.release();
    else await acquire();
  } catch {
    // a low battery forbids it
    return;
  } finally {
    asking = false;
  }
  void adjust(); // the scan may have ended meanwhile
}

async function acquire(): Promise<void> {
  const taken = await navigator.wakeLock.request("screen");
  lock = taken;
  taken.addEventListener("release", () => {
    lock = null;
  });
}

/** While a scan runs, the screen stays on. Browsers allow that over https, and on the station itself. */
export function startWakeLock(): void {
  if (!("wakeLock" in navigator)) return;
  subscribe(() => void adjust());
  document.addEventListener("visibilitychange", () => void adjust());
}
