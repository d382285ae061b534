import type { DeviceKind } from "../api/deviceCommands";
import type { DevicesView, DriverForm } from "../api/wire";
import { currentLanguage, t } from "../state/language";

/** The drivers for a kind of device, each once: those that most people need first, the others by title. */
export function driversOf(view: DevicesView, kind: DeviceKind): DriverForm[] {
  return view.drivers
    .filter((one) => one.kind === kind && !one.alias)
    .sort((a, b) => Number(b.usual) - Number(a.usual) || a.title.localeCompare(b.title, currentLanguage()));
}

/** What a driver is for; one that is not installed has its own name. */
export function driverTitle(view: DevicesView, kind: DeviceKind, name: string): string {
  return view.drivers.find((one) => one.kind === kind && one.name === name)?.title ?? name;
}

/** Of a device that no search has found. */
export function manualTitle(kind: DeviceKind): string {
  return kind === "arm" ? t("ui-another-arm") : t("ui-another-camera");
}

export function kindTitle(kind: DeviceKind): string {
  return kind === "arm" ? t("ui-arm") : t("ui-camera");
}
