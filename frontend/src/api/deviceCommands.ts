import { addressOf } from "../state/base";
import { t } from "../state/language";
import { ask } from "./commands";
import { drop, get, post } from "./http";
import type { DevicesView, TrialView } from "./wire";

export type DeviceKind = TrialView["kind"];
export type Options = Record<string, unknown>;

/** A driver with its options; numbers may be typed text. */
export interface Choice {
  kind: DeviceKind;
  driver: string;
  options: Options;
}

const PATH = "/api/devices";

export const readDevices = () => get<DevicesView>(PATH);
export const readTrial = () => get<TrialView | null>(`${PATH}/trial`);

export const searchDevices = () => ask(() => post<DevicesView>(`${PATH}/search`), t("ui-the-search-was-not-started"));

export const tryDevice = (choice: Choice) =>
  ask(() => post<TrialView>(`${PATH}/trial`, choice), t("ui-the-device-was-not-opened"));

export const chooseDevice = (choice: Choice, label: string) =>
  ask(() => post<DevicesView>(PATH, { ...choice, label }), t("ui-the-device-was-not-saved"));

export const removeDevice = (kind: DeviceKind) =>
  ask(() => post<DevicesView>(`${PATH}/remove`, { kind }), t("ui-the-device-was-not-changed"));

export const describeCamera = (stripe_axis: "u" | "v") =>
  ask(() => post<DevicesView>(`${PATH}/datasheet`, { stripe_axis }), t("ui-the-datasheet-was-not-written"));

export const describeArm = () =>
  ask(() => post<DevicesView>(`${PATH}/arm-datasheet`), t("ui-the-datasheet-was-not-written"));

/** The station closes it by itself if this does not arrive. */
export async function endTrial(): Promise<void> {
  try {
    await drop(`${PATH}/trial`);
  } catch {
    /* it is closed when nobody looks any more */
  }
}

/** The address of a picture: each has its own, so that none is shown from memory. */
export const trialPicture = ({ number, picture }: TrialView) =>
  addressOf(`${PATH}/trial/picture.jpg?n=${number}-${picture}`);
