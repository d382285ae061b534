import { useSyncExternalStore } from "react";

import type { Quality } from "../api/types";
import type {
  Activity,
  ArmUse,
  ArmView,
  CompareState,
  Control,
  DemonstrationState,
  Devices,
  FlowView,
  Home,
  LibraryState,
  Notice,
  PartView,
  PerformanceView,
  RemoteStation,
  ReplayState,
  ScanStatus,
  SensorChoice,
  SignInState,
  StationInfo,
  StationReport,
  StationSettings,
  VerifyView,
  ViewState,
} from "../api/wire";
import { localized } from "./localized";

export type Connection = "connecting" | "live" | "lost";

/** A guided session, by its name in the live state and in its addresses. */
export type Guide = "flow" | "verify" | "performance" | "arm" | "parts";
export type SessionView = FlowView | VerifyView | PerformanceView | ArmView | PartView;

export interface StationEvent {
  id: number;
  kind: string;
  quality: Quality;
  text: string;
  at: number;
}

/** A message to the operator that stays until it is dismissed, or for a time. */
export interface BannerMessage {
  id: number;
  quality: Quality;
  title: string;
  detail: string;
  remedy: string;
  /** It is over once the station is heard again. */
  untilHeard: boolean;
}

export interface LiveState {
  connection: Connection;
  /** Once the station's whole state has come. Before, what is missing is not known to be absent. */
  known: boolean;
  /** The station answers, but no live connection opens. */
  liveBlocked: boolean;
  /** performance.now() of the newest sign of life, 0 before the first. */
  heardAt: number;
  /** Not known before the station's first answer. */
  session: SignInState | null;
  control: Control | null;
  /** What has the arm. */
  activity: ArmUse | null;
  /** Where the simulated operator is, who does everything once. */
  demonstration: DemonstrationState | null;
  /** Whether an activity that has the arm is to be ended for another one. */
  armQuestion: { activity: Activity; answer: (end: boolean) => void } | null;
  station: StationInfo | null;
  devices: Devices | null;
  /** Of a station with several. */
  sensors: SensorChoice | null;
  flow: FlowView | null;
  scan: ScanStatus | null;
  settings: StationSettings | null;
  /** Of a station that shows a recording again. */
  replay: ReplayState | null;
  home: Home | null;
  arm: ArmView | null;
  verify: VerifyView | null;
  performance: PerformanceView | null;
  parts: PartView | null;
  /** Id of the opened verification record; null for the running verification. */
  record: string | null;
  view: ViewState | null;
  /** What of the records is opened or continued, and the part of the next scan. */
  library: LibraryState | null;
  /** Parts, and the map of a scan against one. */
  compare: CompareState | null;
  /** Of this station, as others see it. */
  report: StationReport | null;
  /** All others that the broker knows. */
  stations: RemoteStation[] | null;
  /** performance.now() of their arrival: they come only when something of them has changed. */
  stationsAt: number;
  /** The last notification. */
  notice: Notice | null;
  event: StationEvent | null;
  /** The pose that was last asked for, by a finding or a figure that names it. */
  look: { pose: number } | null;
  banner: BannerMessage | null;
}

let state: LiveState = {
  connection: "connecting",
  known: false,
  liveBlocked: false,
  heardAt: 0,
  session: null,
  control: null,
  activity: null,
  demonstration: null,
  armQuestion: null,
  station: null,
  devices: null,
  sensors: null,
  flow: null,
  scan: null,
  settings: null,
  replay: null,
  home: null,
  arm: null,
  verify: null,
  performance: null,
  parts: null,
  record: null,
  view: null,
  library: null,
  compare: null,
  report: null,
  stations: null,
  stationsAt: 0,
  notice: null,
  event: null,
  look: null,
  banner: null,
};

const listeners = new Set<() => void>();

export function getState(): LiveState {
  return state;
}

export function setState(change: Partial<LiveState>): void {
  state = { ...state, ...change };
  for (const listener of listeners) listener();
}

export function subscribe(listener: () => void): () => void {
  listeners.add(listener);
  return () => listeners.delete(listener);
}

/** One value of the live state, its texts in this browser's language; the component renders
 *  again only when it changes. */
export function useLive<T>(select: (state: LiveState) => T): T {
  return useSyncExternalStore(subscribe, () => select(localized(state)));
}

/** Displays the picture of a pose, where it is available. */
export function lookAtPose(pose: number): void {
  setState({ look: { pose } });
}

/** Takes a newer view of a guided session; an older one, come late by another road, is dropped. */
export function putView(guide: Guide, view: SessionView): void {
  const current = state[guide];
  if (current && current.session_id === view.session_id && current.rev > view.rev) return;
  setState({ [guide]: view } as Partial<LiveState>);
}
