/** What goes over the live connection. The Python side is in app/wire/schema.py. */

import type { Control, You } from "./accessTypes";
import type { ArmView } from "./armTypes";
import type { Devices } from "./deviceTypes";
import type { FlowView } from "./flowTypes";
import type { Home, Station } from "./homeTypes";
import type { ReplayState, ScanState } from "./scanTypes";
import type { StationSettings } from "./settingsTypes";
import type { Quality } from "./types";
import type { VerifyView } from "./verifyTypes";
import type { ViewState } from "./viewTypes";
import type { StationShown } from "./watchTypes";

/** Server to client over /api/live (JSON text frames). */
export type LiveMessage =
  | { type: "hello"; station: Station; you: You }
  | { type: "topic"; name: "control"; value: Control }
  | { type: "topic"; name: "devices"; value: Devices }
  | { type: "topic"; name: "flow"; value: FlowView }
  | { type: "topic"; name: "scan"; value: ScanState }
  | { type: "topic"; name: "settings"; value: StationSettings }
  | { type: "topic"; name: "replay"; value: ReplayState }
  | { type: "topic"; name: "home"; value: Home }
  | { type: "topic"; name: "arm"; value: ArmView }
  | { type: "topic"; name: "verify"; value: VerifyView }
  | { type: "topic"; name: "view"; value: ViewState }
  | { type: "topic"; name: "stations"; value: StationShown[] }
  | { type: "event"; id: number; kind: string; quality: Quality; text: string }
  | { type: "beat" };

/** Client to server over /api/live. */
export type LiveRequest =
  | { type: "beat" }
  | { type: "preview"; on: boolean }
  | { type: "preview_ack"; seq: number }
  | { type: "stations"; on: boolean };
