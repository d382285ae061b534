import type { Text } from "../messages/text";
import { addressOf } from "../state/base";
import { render, t } from "../state/language";
import { localized } from "../state/localized";
import type { Problem } from "./wire";

/** The station refused, for a reason. */
export class Refused extends Error {
  readonly problem: Problem;
  constructor(problem: Problem) {
    super(problem.title);
    this.problem = problem;
  }
}

/** The station did not answer: it is unknown whether it acted. A starting station does not answer either. */
export class NoAnswer extends Error {}

const ANSWER_WITHIN_MS = 10_000;

/** The English texts of a problem as data. */
interface ProblemTexts {
  detail: Text;
  remedy: Text;
}

function problemOf(status: number, text: string): Problem {
  try {
    const { messages, ...problem } = JSON.parse(text) as Partial<Problem> & { messages?: Partial<ProblemTexts> };
    const { detail = "", remedy = "" } = { ...problem, ...messages };
    if (typeof problem.title === "string") {
      return { type: "", code: "", ...problem, detail: render(detail), remedy: render(remedy) } as Problem;
    }
  } catch {
    /* not JSON: its status is all there is */
  }
  return {
    type: "about:blank",
    title: t("ui-the-station-refused-the-request-status", { status }),
    status,
    detail: t("ui-nothing-was-changed"),
    code: "http",
    remedy: t("ui-try-again-if-error-persists-check"),
  };
}

/** A complete answer; an interrupted one does not count. */
async function request(path: string, init: RequestInit): Promise<Blob> {
  let answer: Response;
  let content: Blob;
  try {
    answer = await fetch(addressOf(path), { ...init, signal: AbortSignal.timeout(ANSWER_WITHIN_MS) });
    content = await answer.blob();
  } catch {
    throw new NoAnswer(path);
  }
  if (answer.ok) return content;
  const problem = problemOf(answer.status, await content.text());
  throw problem.code === "starting" ? new NoAnswer(path) : new Refused(problem);
}

const requestText = async (path: string, init: RequestInit) => (await request(path, init)).text();

/** The file at an address. */
export const getFile = (path: string) => request(path, { method: "GET" });

/** The file that an address makes of what it is sent. */
export const postForFile = (path: string, body: unknown) => request(path, postInit(body));

const postInit = (body: unknown): RequestInit => ({
  method: "POST",
  headers: { "Content-Type": "application/json" },
  body: JSON.stringify(body),
});

/** The data at an address, in this browser's language. */
export async function get<T>(path: string): Promise<T> {
  return localized(JSON.parse(await requestText(path, { method: "GET" })) as T);
}

export async function post<T>(path: string, body: unknown = {}): Promise<T | null> {
  return parsed<T>(await requestText(path, postInit(body)));
}

/** Sends a piece of a file. */
export async function putBytes<T>(path: string, body: Blob): Promise<T | null> {
  return parsed<T>(await requestText(path, { method: "PUT", body }));
}

/**
 * A command, repeated with the same key if there is no answer: the station acts only once.
 */
export async function postOnce<T>(path: string, command: { key: string }): Promise<T | null> {
  try {
    return await post<T>(path, command);
  } catch (error) {
    if (!(error instanceof NoAnswer)) throw error;
    return post<T>(path, command);
  }
}

/** Deletes something. */
export async function drop<T>(path: string): Promise<T | null> {
  return parsed<T>(await requestText(path, { method: "DELETE" }));
}

function parsed<T>(text: string): T | null {
  return text ? (JSON.parse(text) as T) : null;
}
