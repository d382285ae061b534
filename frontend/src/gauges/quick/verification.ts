import type { Quality } from "../../api/types";
import type {
  CloudLine,
  FigureLine,
  FiltersPart,
  RulePart,
  VerdictLine,
  VerificationFile,
  VerifyPicture,
} from "../../api/wire";
import { measured, signedLength } from "../../controls/lengths";
import { decimalsBeside } from "../../controls/limits";
import type { Cell, TableData } from "../../controls/table";
import { uncertaintyQuantity } from "../../controls/uncertainty";
import { message, type PlainId, quantity, type Text } from "../../messages/text";
import { budgetTables, statedUncertainties } from "./budget";

/** The displayed verification: the running one, or one of the records. */
export interface DisplayedVerification {
  shape: "plane" | "sphere";
  clouds: CloudLine[];
  figures: FigureLine[];
  verdict: VerdictLine | null;
  notes: string[];
  rule: RulePart | null;
  filters: FiltersPart | null;
}

export const QUALITY: Record<FigureLine["decision"], Quality> = {
  pass: "good",
  fail: "bad",
  uncertain: "attention",
  none: "neutral",
};

export const DECISIONS: Record<FigureLine["decision"], PlainId> = {
  pass: "ui-pass",
  fail: "ui-fail",
  uncertain: "ui-uncertain",
  none: "ui-no-limit",
};

const NOTHING: Omit<CloudLine, "number"> = {
  state: "good",
  text: "",
  points: 0,
  used: 0,
  rms_um: null,
  form_um: null,
  in_gate: null,
  form_all_um: null,
  range_all_um: null,
  angle_arcsec: null,
  z_error_um: null,
  offset_error_um: null,
  radius_error_um: null,
  centre_error_um: null,
  map_url: "",
};

export function displayedOf(picture: VerifyPicture): DisplayedVerification {
  const { clouds, figures: found, verdict, rule, filters } = picture;
  return {
    shape: picture.shape ?? "plane",
    clouds: clouds.filter(({ state }) => state === "good"),
    figures: found,
    verdict,
    notes: [],
    rule,
    filters,
  };
}

export function displayedRecord(record: VerificationFile): DisplayedVerification {
  const clouds = record.clouds.map((cloud) => {
    const number = Number(/cloud-(\d+)/.exec(cloud.recording)?.[1] ?? 0);
    return { ...NOTHING, ...cloud, number, map_url: `/api/verifications/${record.id}/cloud/${number}/map` };
  });
  const found = record.figures.map((figure) => ({
    ...figure,
    limit: figure.limit ?? null,
    test_uncertainty: figure.test_uncertainty ?? null,
    judged_by: figure.judged_by ?? "measurement",
    clouds: figure.clouds ?? [],
    budget: figure.budget ?? {},
    spread: figure.spread ?? {},
  }));
  return {
    shape: record.gauge.shape,
    clouds,
    figures: found,
    verdict: record.verdict,
    notes: record.notes,
    rule: record.rule ?? null,
    filters: record.filters ?? null,
  };
}

/** A figure with its unit; with a sign only if both signs are possible. */
export function worded({
  name,
  value,
  unit,
  limit = null,
}: Pick<FigureLine, "name" | "value" | "unit"> & Partial<Pick<FigureLine, "limit">>): string {
  const both = name === "offset" || name === "z_error" || name === "radius_error";
  return (both ? signedLength : measured)(value, unit, decimalsBeside(value, limit, 1));
}

const COLUMNS: { name: keyof CloudLine; title: PlainId; unit: string }[] = [
  { name: "points", title: "ui-points", unit: "" },
  { name: "used", title: "ui-used", unit: "" },
  { name: "rms_um", title: "ui-rms", unit: "µm" },
  { name: "form_um", title: "ui-form-filtered", unit: "µm" },
  { name: "in_gate", title: "ui-in-gate", unit: "" },
  { name: "form_all_um", title: "ui-form-of-all", unit: "µm" },
  { name: "range_all_um", title: "ui-range-of-all", unit: "µm" },
  { name: "angle_arcsec", title: "ui-angle", unit: "″" },
  { name: "z_error_um", title: "ui-z-error", unit: "µm" },
  { name: "offset_error_um", title: "ui-distance", unit: "µm" },
  { name: "radius_error_um", title: "ui-radius-error", unit: "µm" },
  { name: "centre_error_um", title: "ui-centre-error", unit: "µm" },
];

/** The figures with their limits, and cloud by cloud. */
export function tablesOf({ clouds, figures: found }: DisplayedVerification): TableData[] {
  const known = COLUMNS.filter(({ name }) => clouds.some((cloud) => cloud[name] !== null));
  const number = (value: unknown, unit: string): Text =>
    typeof value === "number" ? quantity(value, unit, unit ? 1 : 0) : "–";
  return [
    {
      title: "ui-figures",
      head: [
        "ui-figure",
        "ui-value",
        "ui-u-k-2",
        "ui-u-test-k-2",
        "ui-judged-by",
        "ui-limit",
        "ui-unit",
        "ui-decision",
      ],
      rows: found.map((f) => [
        f.title,
        quantity(f.value, f.unit, 1),
        ...uncertaintyCells(f),
        message(f.judged_by === "test" ? "ui-u-test" : "ui-u-measurement"),
        f.limit === null ? "–" : quantity(f.limit, f.unit),
        { unit: f.unit },
        message(DECISIONS[f.decision]),
      ]),
      wide: true,
    },
    ...budgetTables(found),
    {
      title: "ui-clouds",
      head: ["ui-cloud", ...known],
      rows: clouds.map((cloud) => [`${cloud.number}`, ...known.map(({ name, unit }) => number(cloud[name], unit))]),
      wide: true,
    },
  ];
}

function uncertaintyCells(figure: FigureLine): Cell[] {
  const { measurement, test } = statedUncertainties(figure);
  return [measurement, test].map((value) => (value === null ? "–" : uncertaintyQuantity(value, figure.unit)));
}
