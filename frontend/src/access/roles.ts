import type { Role } from "../api/types";
import type { PlainId } from "../messages/text";

export const ROLES: Record<Role, PlainId> = {
  viewer: "ui-viewer",
  operator: "ui-operator-lowercase",
  admin: "ui-administrator",
};
