/** Names for parts of the generated types, and the messages of the live connection. */

import type {
  BeatMessage,
  BlockGeometry,
  BoardGeometry,
  CurrentUser,
  EventMessage,
  Finding,
  FittedShape,
  FlowView,
  Heartbeat,
  HelloMessage,
  PageView,
  PreviewAck,
  PreviewRequest,
  StationsRequest,
  Topics,
  Validity,
  Region as ViewRegion,
  ViewState,
} from "./wire";

export type Quality = Finding["quality"];
export type Role = CurrentUser["role"];
export type WorkPage = Validity["page"];
export type Picture = FlowView["picture"];
/** The calibration target. */
export type ObjectGeometry = BlockGeometry | BoardGeometry;
export type Measure = ViewState["measure"];
export type Viewpoint = PageView["viewpoint"];
export type ShapeName = FittedShape["shape"];
/** What is looked for in a rectangle; `any`: the likeliest. */
export type AskedShape = ViewRegion["shape"];
/** Shares of the 3D view, 0 to 1 from its left and from its top. */
export type Region = Pick<ViewRegion, "left" | "top" | "right" | "bottom">;
export type Vec3 = [number, number, number];

type TopicMessage = { [Name in keyof Topics]: { type: "topic"; name: Name; value: Topics[Name] } }[keyof Topics];

/** Server to client over /api/live (JSON text frames). */
export type LiveMessage = HelloMessage | TopicMessage | EventMessage | BeatMessage;

/** Client to server over /api/live. */
export type LiveRequest = Heartbeat | PreviewRequest | PreviewAck | StationsRequest;
