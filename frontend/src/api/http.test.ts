import { afterEach, expect, test, vi } from "vitest";

import { message } from "../messages/text";
import { chooseLanguage } from "../state/language";
import { get, NoAnswer, postOnce, Refused } from "./http";

const answers = (...responses: (Response | Error)[]) => {
  const fetched = vi.fn();
  for (const response of responses) {
    if (response instanceof Error) fetched.mockRejectedValueOnce(response);
    else fetched.mockResolvedValueOnce(response);
  }
  vi.stubGlobal("fetch", fetched);
  return fetched;
};
const problem = (body: object) => new Response(JSON.stringify(body), { status: 409 });
const PROBLEM = { type: "about:blank", title: "Conflict", status: 409, detail: "Open", code: "busy", remedy: "Wait" };

afterEach(async () => {
  vi.unstubAllGlobals();
  await chooseLanguage("en");
});

async function refusal(answer: Response) {
  answers(answer);
  const error = await get("/api/home").catch((caught: unknown) => caught);
  expect(error).toBeInstanceOf(Refused);
  return (error as Refused).problem;
}

test("a problem's messages go before its English", async () => {
  await chooseLanguage("de");
  expect(await refusal(problem(PROBLEM))).toMatchObject({ detail: "Open", remedy: "Wait", code: "busy" });
  const messages = { detail: message("ui-open"), remedy: "" };
  expect(await refusal(problem({ ...PROBLEM, messages }))).toMatchObject({ detail: "Öffnen", remedy: "" });
});

test("what is no problem is described by its status", async () => {
  expect(await refusal(new Response("<html>", { status: 502 }))).toMatchObject({
    title: "The station refused the request (status 502)",
    code: "http",
  });
});

test("what is there comes in the browser's language", async () => {
  await chooseLanguage("de");
  answers(new Response(JSON.stringify({ title: message("ui-open") })));
  expect(await get("/api/home")).toEqual({ title: "Öffnen" });
});

test("a command without an answer is sent once more, a refused one is not", async () => {
  const fetched = answers(new TypeError("network"), new Response("{}"));
  expect(await postOnce("/api/flow/command", { key: "k" })).toEqual({});
  expect(fetched.mock.calls.map(([, init]) => init.body)).toEqual(['{"key":"k"}', '{"key":"k"}']);
  const refused = answers(problem(PROBLEM));
  await expect(postOnce("/api/flow/command", { key: "k" })).rejects.toBeInstanceOf(Refused);
  expect(refused).toHaveBeenCalledTimes(1);
  answers(problem({ ...PROBLEM, code: "starting" }), new TypeError("network"));
  await expect(postOnce("/api/flow/command", { key: "k" })).rejects.toBeInstanceOf(NoAnswer);
});
