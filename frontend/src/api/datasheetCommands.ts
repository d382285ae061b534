import type { Text } from "../messages/text";
import { clearBanner } from "../state/banner";
import { t } from "../state/language";
import { localized } from "../state/localized";
import { ask, notifyOfError } from "./commands";
import { get, post, Refused } from "./http";
import type {
  ArmModelView,
  DatasheetCheck,
  DatasheetRow,
  DatasheetsView,
  FieldProblem,
  JointsView,
  Problem,
} from "./wire";

export const DATASHEETS = "/api/datasheets";

/** A document to be kept: a file as it is, or what was entered. */
export interface NewDatasheet {
  /** Of the file; empty of a form. */
  name: string;
  text: string;
  /** The version that was edited, which is retired; empty of a new one. */
  edited: string;
}

/** Keeps a datasheet; the problem where the thing has one already, null where it was not kept. */
export async function addDatasheet(added: NewDatasheet, replace: boolean): Promise<DatasheetRow | Problem | null> {
  try {
    const row = await post<DatasheetRow>(DATASHEETS, { ...added, replace });
    clearBanner();
    return localized(row);
  } catch (error) {
    if (error instanceof Refused && error.problem.code === "datasheet-exists") return error.problem;
    notifyOfError(error, t("ui-the-datasheet-was-not-kept"));
    return null;
  }
}

/** What the station says of a document, as data: a form says it in its own words. */
export type CheckedDatasheet = Omit<DatasheetCheck, "problems" | "note"> & {
  problems: (Omit<FieldProblem, "text"> & { text: Text })[];
  note: Text;
};

export const checkDatasheet = (text: string) => post<CheckedDatasheet>(`${DATASHEETS}/check`, { name: "", text });

export const readJoints = () => get<JointsView>(`${DATASHEETS}/joints`);

/** What the station makes of a text with the model of an arm. */
export const readArmModel = async (text: string, answers: Record<string, string>) =>
  localized(await post<ArmModelView>(`${DATASHEETS}/model`, { text, answers }));

const reference = ({ kind, file, version }: DatasheetRow) => ({ kind, file, version });

export const retireDatasheet = (row: DatasheetRow) =>
  ask(() => post<DatasheetsView>(`${DATASHEETS}/retire`, reference(row)), t("ui-the-datasheet-was-not-changed"));

/** Brings one back; the problem where the thing has another one in use, null where it did not come. */
export async function restoreDatasheet(row: DatasheetRow, replace: boolean): Promise<DatasheetsView | Problem | null> {
  try {
    const view = await post<DatasheetsView>(`${DATASHEETS}/restore`, { ...reference(row), replace });
    clearBanner();
    return localized(view);
  } catch (error) {
    if (error instanceof Refused && error.problem.code === "datasheet-exists") return error.problem;
    notifyOfError(error, t("ui-the-datasheet-was-not-changed"));
    return null;
  }
}

/** The address of the file itself. */
export const fileOf = ({ kind, file, retired }: DatasheetRow) =>
  `${DATASHEETS}/${kind}/${encodeURIComponent(file)}${retired ? "?retired=true" : ""}`;
