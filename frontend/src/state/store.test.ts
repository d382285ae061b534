import { beforeEach, expect, test, vi } from "vitest";

import type { FlowView } from "../api/wire";
import { clearBanner, noteReturn, notify } from "./banner";
import { getState, lookAtPose, putView, setState, subscribe } from "./store";

const view = (session_id: string, rev: number) => ({ session_id, rev }) as FlowView;

beforeEach(() => setState({ flow: null, banner: null }));

test("an older view of the same session is dropped, one of another is not", () => {
  putView("flow", view("a", 5));
  putView("flow", view("a", 4));
  expect(getState().flow?.rev).toBe(5);
  putView("flow", view("a", 5));
  putView("flow", view("a", 6));
  expect(getState().flow?.rev).toBe(6);
  putView("flow", view("b", 1));
  expect(getState().flow).toEqual({ session_id: "b", rev: 1 });
});

test("listeners are called on each change, until they leave", () => {
  const listener = vi.fn();
  const leave = subscribe(listener);
  lookAtPose(3);
  expect(getState().look).toEqual({ pose: 3 });
  leave();
  lookAtPose(4);
  expect(listener).toHaveBeenCalledTimes(1);
});

test("a banner stays until it is dismissed, or for its time", () => {
  vi.useFakeTimers();
  notify({ quality: "bad", title: "No answer", untilHeard: true });
  expect(getState().banner).toMatchObject({ title: "No answer", detail: "", remedy: "" });
  noteReturn();
  expect(getState().banner?.quality).toBe("neutral");
  vi.advanceTimersByTime(9000);
  expect(getState().banner).toBeNull();
  notify({ quality: "bad", title: "It stays" });
  noteReturn();
  expect(getState().banner?.title).toBe("It stays");
  clearBanner();
  expect(getState().banner).toBeNull();
  vi.useRealTimers();
});
