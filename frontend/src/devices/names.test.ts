import { expect, test } from "vitest";

import type { DevicesView, DriverForm } from "../api/wire";
import { driversOf, driverTitle } from "./names";

const form = (name: string, title: string, more: Partial<DriverForm> = {}): DriverForm => ({
  kind: "sensor",
  name,
  title,
  usual: false,
  alias: false,
  fields: [],
  problem: "",
  ...more,
});
const drivers = [
  form("bench", "Test bench"),
  form("folder", "Folder of pictures"),
  form("bridge", "Encoder arm", { kind: "arm", usual: true }),
  form("opencv", "USB camera", { usual: true }),
  form("copy", "USB camera", { alias: true }),
];
const view = { drivers } as Partial<DevicesView> as DevicesView;

test("drivers are offered once, those that most people need first, the others by their titles", () => {
  expect(driversOf(view, "sensor").map((one) => one.name)).toEqual(["opencv", "folder", "bench"]);
});

test("a driver that is not installed has its own name", () => {
  expect(driverTitle(view, "sensor", "folder")).toBe("Folder of pictures");
  expect(driverTitle(view, "arm", "folder")).toBe("folder");
});
