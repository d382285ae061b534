import type { DeviceKind } from "../api/deviceCommands";
import type { DevicesView, DriverForm, OptionField } from "../api/wire";
import type { PlainId } from "../messages/text";
import { t } from "../state/language";

/** In the order in which they are offered; drivers of other packages follow. */
const DRIVERS: Record<string, PlainId> = {
  bridge: "ui-driver-bridge",
  "serial-encoder": "ui-driver-bridge",
  microscribe: "ui-driver-microscribe",
  "ur-rtde": "ui-driver-ur-rtde",
  fanuc: "ui-driver-fanuc",
  "kuka-rsi": "ui-driver-kuka-rsi",
  "abb-egm": "ui-driver-abb-egm",
  ros2: "ui-driver-ros2",
  opencv: "ui-driver-opencv",
  genicam: "ui-driver-genicam",
  pylon: "ui-driver-pylon",
  gentl: "ui-driver-gentl",
  folder: "ui-driver-folder",
};

const OPTIONS: Record<string, PlainId> = {
  address: "ui-option-address",
  base: "ui-option-base",
  baudrate: "ui-option-baudrate",
  bayer: "ui-option-bayer",
  child_frame: "ui-option-child-frame",
  chunks: "ui-option-chunks",
  counts_per_revolution: "ui-option-counts-per-revolution",
  domain_id: "ui-option-domain-id",
  exposure_range_us: "ui-option-exposure-range",
  exposure_us: "ui-exposure",
  external_axis: "ui-option-external-axis",
  gain_db: "ui-option-gain",
  height_px: "ui-option-height",
  host: "ui-option-host",
  joint_names: "ui-option-joint-names",
  joint_count: "ui-option-joint-count",
  kind: "ui-option-kind",
  laser_colour: "ui-option-laser-colour",
  laser_line: "ui-option-laser-line",
  latency_us: "ui-option-latency",
  line_offset_px: "ui-option-line-offset",
  line_rate_hz: "ui-option-line-rate",
  line_rows: "ui-option-line-rows",
  line_sigma_px: "ui-option-line-sigma",
  loop: "ui-option-loop",
  packet_size: "ui-option-packet-size",
  parent_frame: "ui-option-parent-frame",
  path: "ui-option-path",
  producer: "ui-option-producer",
  pixel_format: "ui-option-pixel-format",
  port: "ui-option-port",
  rate_hz: "ui-rate",
  region: "ui-option-region",
  report: "ui-option-report",
  serial: "ui-option-serial",
  serial_number: "ui-option-serial",
  setting: "ui-option-setting",
  source: "ui-option-source",
  stamp_at: "ui-option-stamp-at",
  stamps: "ui-time-stamps",
  timeout_s: "ui-option-timeout",
  tool: "ui-option-tool",
  topic: "ui-option-topic",
  trigger: "ui-option-trigger",
  trigger_edge: "ui-option-trigger-edge",
  url: "ui-option-url",
  width_px: "ui-option-width",
};

/** What a driver is for; that of another package has its own name. */
export function driverTitle(name: string): string {
  const id = DRIVERS[name];
  return id ? t(id) : name;
}

/** The drivers for a kind of device, each once, in the order in which they are offered. */
export function driversOf(view: DevicesView, kind: DeviceKind): DriverForm[] {
  const known = Object.keys(DRIVERS);
  const place = ({ name }: DriverForm) => (known.includes(name) ? known.indexOf(name) : known.length);
  return view.drivers.filter((one) => one.kind === kind && !one.alias).sort((a, b) => place(a) - place(b));
}

/** The label of an option; one that is not known has the name of its key, without the unit. */
export function optionLabel({ key, unit }: OptionField): string {
  const id = OPTIONS[key];
  if (id) return t(id);
  const words = (unit ? key.replace(/_[a-z]+$/, "") : key).replaceAll("_", " ");
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** Of a device that no search has found. */
export function manualTitle(kind: DeviceKind): string {
  return kind === "arm" ? t("ui-another-arm") : t("ui-another-camera");
}

export function kindTitle(kind: DeviceKind): string {
  return kind === "arm" ? t("ui-arm") : t("ui-camera");
}
