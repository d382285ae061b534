import { noteReturn, notify } from "../state/banner";
import { addressOf, BASE } from "../state/base";
import { t } from "../state/language";
import { playFor } from "../state/sounds";
import { getState, type LiveState, putView, setState, subscribe } from "../state/store";
import { previewInterest, showPreview } from "./preview";
import { readSession } from "./session";
import { stationsInterest } from "./stations";
import type { LiveMessage, LiveRequest } from "./types";
import type { CurrentUser, SignInState } from "./wire";

const SILENCE_MS = 2500;
/** Whoever has control keeps it so. */
const BEAT_MS = 5000;
/** So many in a row are no accident. */
const BLOCKED_AFTER = 3;
const RETRY_MS = [250, 500, 1000, 2000];

let socket: WebSocket | null = null;
let openedAt = 0;
let beatAt = Number.NEGATIVE_INFINITY;
let attempt = 0;
/** Connections that ended without being opened, although the station answered. */
let unopened = 0;
/** After a new connection its first view counts, whatever the state was before. */
let resync = true;
/** Nobody is signed in here. */
let waiting = true;
let pending: Partial<LiveState> = {};
let flushing = false;

function send(request: LiveRequest): void {
  if (socket?.readyState === WebSocket.OPEN) socket.send(JSON.stringify(request));
}

/** Many topics within one picture of the screen cost one rendering: the latest wins. */
function put(change: Partial<LiveState>): void {
  pending = { ...pending, ...change };
  if (flushing) return;
  flushing = true;
  setTimeout(() => {
    const { flow, ...rest } = pending;
    pending = {};
    flushing = false;
    setState(rest);
    if (!flow) return;
    if (resync) setState({ flow });
    else putView("flow", flow);
    resync = false;
  }, 16);
}

/** Renders nothing while live: the age of the last word is read by those who show it. */
function heard(): void {
  getState().heardAt = performance.now();
  if (getState().connection === "live") return;
  setState({ connection: "live" });
  noteReturn();
}

function onEvent(message: Extract<LiveMessage, { type: "event" }>): void {
  const { id, kind, quality, text } = message;
  put({ event: { id, kind, quality, text, at: performance.now() } });
  playFor(kind);
  // banners display the device's own state, and the note that stays
  if (kind.endsWith("-lost") || kind === "unattended-stop") return;
  if (quality === "bad" || quality === "attention") notify({ quality, title: text }, 8000);
}

function onText(text: string): void {
  const message = JSON.parse(text) as LiveMessage;
  switch (message.type) {
    case "hello":
      resync = true;
      put({ station: message.station, session: signedIn(message.you) });
      break;
    case "topic":
      put({
        [message.name]: message.value,
        // it changes with the devices that are chosen
        ...(message.name === "home" && { station: message.value.station }),
        ...(message.name === "stations" && { stationsAt: performance.now() }),
      });
      break;
    case "event":
      onEvent(message);
      break;
    case "beat":
      if (!getState().known) put({ known: true });
      beat(); // timers of a hidden tab are slowed down, messages are not
      break;
  }
}

/** Keeps control; a page that is frozen or gone does not. */
function beat(): void {
  if (performance.now() - beatAt < BEAT_MS) return;
  beatAt = performance.now();
  send({ type: "beat" });
}

function signedIn(you: CurrentUser | null): SignInState | null {
  const { session } = getState();
  return session && { ...session, you };
}

async function onBinary(from: WebSocket, data: ArrayBuffer): Promise<void> {
  const seq = await showPreview(data);
  if (from === socket) send({ type: "preview_ack", seq });
}

function connect(): void {
  const address = new URL(addressOf("/api/live"), BASE);
  address.protocol = BASE.protocol.replace("http", "ws");
  const opened = new WebSocket(address);
  opened.binaryType = "arraybuffer";
  socket = opened;
  openedAt = performance.now();
  opened.onopen = () => {
    attempt = 0;
    unopened = 0;
    if (getState().liveBlocked) setState({ liveBlocked: false });
    heard();
    if (previewInterest.wanted) send({ type: "preview", on: true });
    if (stationsInterest.wanted) send({ type: "stations", on: true });
  };
  opened.onmessage = (message: MessageEvent<string | ArrayBuffer>) => {
    if (opened !== socket) return;
    heard();
    if (typeof message.data === "string") onText(message.data);
    else void onBinary(opened, message.data);
  };
  opened.onclose = () => {
    if (opened !== socket) return;
    unopened++; // 1 after one that was open, and the next one that opens sets it to 0
    lose();
  };
}

function lose(): void {
  const old = socket;
  socket = null;
  old?.close();
  if (getState().connection === "live") setState({ connection: "lost" });
  setTimeout(() => void again(), RETRY_MS[Math.min(attempt++, RETRY_MS.length - 1)]);
}

/** Connects again; who is no longer signed in gets a notice, and is connected after the next sign-in. */
async function again(): Promise<void> {
  const before = getState().session?.you;
  await readSession();
  if (getState().session?.you) {
    if (unopened >= BLOCKED_AFTER && !getState().liveBlocked) setState({ liveBlocked: true });
    return connect();
  }
  waiting = true;
  if (before?.kiosk) {
    notify({
      quality: "attention",
      title: t("ui-kiosk-link-screen-revoked"),
      remedy: t("ui-ask-administrator-new-link"),
    });
  } else if (before) {
    notify({ quality: "attention", title: t("ui-you-have-been-signed-out"), remedy: t("ui-sign-in-to-continue") });
  }
}

/** Opens the one live connection of this tab once somebody is signed in, and keeps it for ever. */
export function startLive(): void {
  setState({ heardAt: performance.now() });
  previewInterest.listen((on) => send({ type: "preview", on }));
  stationsInterest.listen((on) => send({ type: "stations", on }));
  subscribe(() => {
    if (!waiting || !getState().session?.you) return;
    waiting = false;
    connect();
  });
  setInterval(beat, BEAT_MS / 2);
  setInterval(() => {
    if (waiting) return;
    const now = performance.now();
    if (now - getState().heardAt < SILENCE_MS) return;
    if (getState().connection !== "lost") setState({ connection: "lost" });
    if (socket && now - Math.max(openedAt, getState().heardAt) > 3 * SILENCE_MS) lose();
  }, 500);
}
