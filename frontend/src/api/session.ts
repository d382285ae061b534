import { clearBanner } from "../state/banner";
import { BASE, stationPath } from "../state/base";
import { t } from "../state/language";
import { asSent } from "../state/localized";
import { setState } from "../state/store";
import { done, notifyOfError } from "./commands";
import { drop, get, NoAnswer, post } from "./http";
import type { Role } from "./types";
import type { AccessTokenSummary, AccountSummary, Control, ProviderPage, ProviderReply, SignInState } from "./wire";

const AGAIN_MS = 1000;
/** The page to which a provider of accounts sends the browser back. */
const PROVIDER_PATH = "/sign-in";
/** In the session storage: the page that was open before. */
const PATH_BEFORE = "crenel-path-before-sign-in";

/** The part of a link after its #, removed from the address at once. Earlier kiosk links have "wall". */
function fragment(): { way: "code" | "kiosk"; value: string } | null {
  const found = /^#(code|kiosk|wall)=([\w-]+)$/.exec(window.location.hash);
  if (!found) return null;
  window.history.replaceState(null, "", window.location.pathname);
  return { way: found[1] === "code" ? "code" : "kiosk", value: found[2] ?? "" };
}

/** What a provider of accounts sent, removed from the address at once. */
function providerReply(): ProviderReply | null {
  if (stationPath() !== PROVIDER_PATH) return null;
  const query = new URLSearchParams(window.location.search);
  window.history.replaceState(null, "", sessionStorage.getItem(PATH_BEFORE) ?? BASE.pathname);
  sessionStorage.removeItem(PATH_BEFORE);
  const state = query.get("state");
  return state ? { state, code: query.get("code") ?? "", error: query.get("error") ?? "" } : null;
}

/** Signs in with the provider's answer or the link that opened this page, or continues with the existing sign-in. */
export async function startSession(): Promise<void> {
  const reply = providerReply();
  if (reply) {
    try {
      return put(await post<SignInState>("/api/session/provider/answer", reply));
    } catch (error) {
      notifyOfError(error, t("ui-you-were-not-signed-in"));
    }
  }
  const link = fragment();
  if (link) {
    try {
      put(await post<SignInState>(`/api/session/${link.way}`, { code: link.value }));
      return clearBanner();
    } catch (error) {
      notifyOfError(error, t("ui-the-link-could-not-be-opened"));
    }
  }
  await readSession();
}

/** Until the station answers. */
export async function readSession(): Promise<void> {
  for (;;) {
    try {
      return put(await get<SignInState>("/api/session"));
    } catch (error) {
      if (!(error instanceof NoAnswer)) throw error;
      await new Promise((resolve) => setTimeout(resolve, AGAIN_MS));
    }
  }
}

function put(session: SignInState | null): void {
  if (session) setState({ session: asSent(session) });
}

export const signIn = (name: string, password: string) =>
  done(async () => put(await post<SignInState>("/api/session", { name, password })), t("ui-you-were-not-signed-in"));

export const enterByCode = (code: string) =>
  done(async () => put(await post<SignInState>("/api/session/code", { code })), t("ui-you-were-not-signed-in"));

export const makeAdmin = (code: string, name: string, password: string) =>
  done(
    async () => put(await post<SignInState>("/api/session/admin", { code, name, password })),
    t("ui-the-account-was-not-created"),
  );

/** Opens the sign-in page of the provider of accounts. */
export const signInWithProvider = () =>
  done(async () => {
    const page = await post<ProviderPage>("/api/session/provider");
    if (!page) return;
    sessionStorage.setItem(PATH_BEFORE, window.location.pathname);
    window.location.assign(page.address);
  }, t("ui-you-were-not-signed-in"));

/** Signs out here, and with an account of the provider on its page, too. */
export const signOut = () =>
  done(async () => {
    const session = await drop<SignInState>("/api/session");
    put(session);
    if (session?.sign_out_page) window.location.assign(session.sign_out_page);
  }, t("ui-you-may-still-be-signed-in"));

export const changePassword = (old: string, fresh: string) =>
  done(
    async () => put(await post<SignInState>("/api/session/password", { old, new: fresh })),
    t("ui-the-password-was-not-changed"),
  );

async function control(path: string, body: unknown, whatWas: string): Promise<boolean> {
  return done(async () => {
    const now = await post<Control>(`/api/control/${path}`, body);
    if (now) setState({ control: now });
  }, whatWas);
}

export const askForControl = () => control("ask", {}, t("ui-control-was-not-requested"));
export const answerForControl = (give: boolean) => control("answer", { give }, t("ui-the-answer-was-not-sent"));
export const releaseControl = () => control("release", {}, t("ui-control-was-not-released"));
export const takeControl = (reason: string) => control("take", { reason }, t("ui-control-was-not-taken"));

export const addAccount = (name: string, role: Role, password: string) =>
  done(
    async () => void (await post<AccountSummary>("/api/accounts", { name, role, password })),
    t("ui-the-account-was-not-created"),
  );

export const changeAccount = (name: string, change: { role?: Role; password?: string }) =>
  done(
    async () => void (await post<AccountSummary>(`/api/account?name=${encodeURIComponent(name)}`, change)),
    t("ui-the-account-was-not-changed"),
  );

export const removeAccount = (name: string) =>
  done(
    async () => void (await drop(`/api/account?name=${encodeURIComponent(name)}`)),
    t("ui-the-account-was-not-removed"),
  );

/** The address of the new link, which is shown only once; empty if it was not created. */
export async function addKioskLink(name: string): Promise<string> {
  let address = "";
  await done(async () => {
    const link = await post<AccessTokenSummary>("/api/kiosk-links", { name });
    if (link?.token) address = `${BASE.href}#kiosk=${link.token}`;
  }, t("ui-the-link-was-not-created"));
  return address;
}

export const removeKioskLink = (id: string) =>
  done(async () => void (await drop(`/api/kiosk-links/${id}`)), t("ui-the-link-may-still-be-valid"));
