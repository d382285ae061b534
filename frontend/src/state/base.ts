const OWN_FILE = import.meta.url;

/**
 * Where the station is for this browser: its address, with the sub-path that a proxy may add. It is
 * the folder above that of the client's own files, and `/` while they are developed.
 */
export const BASE = import.meta.env.PROD ? new URL("..", OWN_FILE) : new URL("/", window.location.href);

// relative to the page it would be looked for elsewhere once the client has changed the address
const icon = document.querySelector<HTMLLinkElement>("link[rel=icon]");
if (icon) icon.href = new URL("favicon.svg", BASE).href;

/** The address of a path of the station, such as `/api/session`. */
export function addressOf(path: string): string {
  return BASE.pathname + path.replace(/^\//, "");
}

/** The page's own path at the station, without the sub-path. */
export function stationPath(): string {
  const { pathname } = window.location;
  return pathname.startsWith(BASE.pathname) ? `/${pathname.slice(BASE.pathname.length)}` : pathname;
}

/** What a proxy does not pass on. */
export type ProxyFault = "host" | "scheme" | "sub-path";

/** What differs between the address by which the station was asked and the one that this browser has. */
export function proxyFault(asked: string): ProxyFault | null {
  if (!URL.canParse(asked)) return null;
  const { host, protocol, pathname } = new URL(asked);
  if (host !== BASE.host) return "host";
  if (protocol !== BASE.protocol) return "scheme";
  return pathname === BASE.pathname ? null : "sub-path";
}
