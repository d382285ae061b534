import { t } from "../state/language";
import { spoken } from "../state/spoken";
import type { Problem } from "./types";

/** A refusal of the station, in its own words. */
export class Refused extends Error {
  readonly problem: Problem;
  constructor(problem: Problem) {
    super(problem.title);
    this.problem = problem;
  }
}

/** The station gave no answer: nobody knows whether it acted. */
export class NoAnswer extends Error {}

const ANSWER_WITHIN_MS = 10_000;

async function readProblem(answer: Response): Promise<Problem> {
  try {
    const problem = (await answer.json()) as Partial<Problem>;
    if (typeof problem.title === "string") {
      return { type: "", detail: "", code: "", remedy: "", ...problem } as Problem;
    }
  } catch {
    /* not JSON: told below by its status */
  }
  return {
    type: "about:blank",
    title: t("The station refused with status {status}", { status: answer.status }),
    status: answer.status,
    detail: t("Nothing was changed here."),
    code: "http",
    remedy: t("Try again; if it stays so, look at the station's log."),
  };
}

async function request(path: string, init: RequestInit): Promise<Response> {
  let answer: Response;
  try {
    answer = await fetch(path, { ...init, signal: AbortSignal.timeout(ANSWER_WITHIN_MS) });
  } catch {
    throw new NoAnswer(path);
  }
  if (!answer.ok) throw new Refused(await readProblem(answer));
  return answer;
}

/** What is there, its sentences in this browser's language. */
export async function get<T>(path: string): Promise<T> {
  return spoken((await (await request(path, { method: "GET" })).json()) as T);
}

export async function post<T>(path: string, body: unknown = {}): Promise<T | null> {
  const answer = await request(path, {
    method: "POST",
    headers: { "Content-Type": "application/json" },
    body: JSON.stringify(body),
  });
  return bodyOf<T>(answer);
}

/**
 * A command, sent once more with the same key when no answer came: the station acts only once.
 */
export async function postOnce<T>(path: string, command: { key: string }): Promise<T | null> {
  try {
    return await post<T>(path, command);
  } catch (error) {
    if (!(error instanceof NoAnswer)) throw error;
    return post<T>(path, command);
  }
}

/** Asks for something to be taken away. */
export async function drop<T>(path: string): Promise<T | null> {
  return bodyOf<T>(await request(path, { method: "DELETE" }));
}

async function bodyOf<T>(answer: Response): Promise<T | null> {
  const text = await answer.text();
  return text ? (JSON.parse(text) as T) : null;
}
