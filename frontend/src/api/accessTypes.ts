import type { PlainId } from "../messages/text";

export type Role = "viewer" | "operator" | "admin";

/** Who is signed in at this browser; the id is the sign-in's, as in Control. */
export interface You {
  id: string;
  name: string;
  role: Role;
  wall: boolean;
}

export interface Session {
  station: string;
  you: You | null;
  /** The console's code makes the first administrator. */
  first_start: boolean;
  /** The console's code lets in. */
  by_code: boolean;
}

/** How far a starting station is: so many of its steps are done, a share of the time. */
export interface Readiness {
  ready: boolean;
  station: string;
  steps: string[];
  done: number;
  share: number;
}

export interface Person {
  id: string;
  name: string;
}

/** Who acts, and who would like to. */
export interface Control {
  holder: Person | null;
  asked_by: Person | null;
}

export interface Account {
  name: string;
  role: Role;
  made_at: string;
}

export interface Wall {
  id: string;
  name: string;
  made_by: string;
  made_at: string;
  /** Only where it was made just now. */
  token: string | null;
}

export interface AuditEntry {
  number: number;
  at: string;
  who: string;
  address: string;
  act: string;
  outcome: string;
}

export const ROLES: Record<Role, PlainId> = {
  viewer: "ui-viewer",
  operator: "ui-operator-lowercase",
  admin: "ui-administrator",
};
