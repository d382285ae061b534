import { expect, test } from "vitest";

import type { Quality } from "../api/types";
import type { DeviceReport, StationReport } from "../api/wire";
import { facts, worst } from "./stationFacts";

const CAMERA: DeviceReport = {
  name: "camera",
  sensor: "",
  state: "connected",
  text: "camera",
  age_s: 0.02,
  rate_hz: 60,
  received: 900_000,
  lost: 17_663,
  corrupt: 0,
  quality: "attention",
  lost_lately: 2_265,
  received_lately: 30_000,
  stamps: "device",
};

function camera(device: Partial<DeviceReport>) {
  const report = { devices: [{ ...CAMERA, ...device }], calibration: null, verification: null } as StationReport;
  return facts({ ...report, temperature_c: null, disk_free_gb: 99, control: null, alarms: [] }, 0)[0];
}

test.each<[DeviceReport["state"], number | null]>([
  ["connected", 60],
  ["connected", null],
  ["connecting", null],
  ["lost", null],
  ["off", null],
])("a device %s at %s Hz has the sign that its station gives it", (state, rate_hz) => {
  for (const quality of ["good", "attention", "bad", "neutral"] satisfies Quality[])
    expect(camera({ state, rate_hz, quality })?.quality).toBe(quality);
});

test("of a device that sends nothing yet, it is said why: it may not even be chosen", () => {
  const text = "No camera is chosen.";
  expect(camera({ state: "connecting", text })).toMatchObject({ value: "no data", note: text });
});

test("the losses beside a sign are those that it is given by", () => {
  expect(camera({})?.note).toMatch(/2\D?265 of 32\D?265 lost in 10 min/);
  expect(camera({})?.note).not.toMatch(/17\D?663/);
});

test("a station of an earlier version that says nothing is not called good", () => {
  const earlier = camera({ quality: null, lost_lately: null, received_lately: null });
  expect(earlier?.quality).toBe("neutral");
  expect(earlier?.note).toMatch(/17\D?663/);
});

test("the sign of a station is the worst of its alarms", () => {
  const alarms = (...qualities: Quality[]) =>
    ({ alarms: qualities.map((quality) => ({ quality, text: quality, remedy: "" })) }) as StationReport;
  expect(worst(alarms())).toBe("good");
  expect(worst(alarms("attention"))).toBe("attention");
  expect(worst(alarms("attention", "bad"))).toBe("bad");
});
