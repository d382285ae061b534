import type { VerificationRecord } from "../api/verifyFiles";
import type { CloudLine, FigureLine, VerdictLine, VerifyPicture } from "../api/verifyTypes";
import { measured, signedLength } from "../parts/lengths";
import type { Quality } from "../api/types";
import { amount, type TableData } from "../parts/table";
import { words } from "../state/language";

/** What is looked at: the open verification, or one of the records. */
export interface Shown {
  shape: "plane" | "sphere";
  clouds: CloudLine[];
  figures: FigureLine[];
  verdict: VerdictLine | null;
  notes: string[];
}

export const QUALITY: Record<FigureLine["decision"], Quality> = {
  pass: "good",
  fail: "bad",
  uncertain: "attention",
  none: "neutral",
};

export const WORD: Record<FigureLine["decision"], string> = {
  pass: words("Pass"),
  fail: words("Fail"),
  uncertain: words("Uncertain"),
  none: words("No limit"),
};

const NOTHING: Omit<CloudLine, "number"> = {
  state: "good",
  text: "",
  points: 0,
  used: 0,
  rms_um: null,
  form_um: null,
  angle_arcsec: null,
  z_error_um: null,
  offset_error_um: null,
  radius_error_um: null,
  centre_error_um: null,
  map_url: "",
};

export function shownOf(picture: VerifyPicture): Shown {
  const { clouds, figures: found, verdict } = picture;
  return { shape: picture.shape ?? "plane", clouds: clouds.filter(({ state }) => state === "good"), figures: found, verdict, notes: [] };
}

export function shownOfRecord(record: VerificationRecord): Shown {
  const clouds = record.clouds.map((cloud) => {
    const number = Number(/cloud-(\d+)/.exec(cloud.recording)?.[1] ?? 0);
    return { ...NOTHING, ...cloud, number, map_url: `/api/verifications/${record.id}/cloud/${number}/map` };
  });
  const found = record.figures.map((figure) => ({ ...figure, limit: figure.limit ?? null, clouds: figure.clouds ?? [] }));
  return { shape: record.gauge.shape, clouds, figures: found, verdict: record.verdict, notes: record.notes };
}

/** A figure with its unit; its sign only where both are possible. */
export function worded({ name, value, unit }: Pick<FigureLine, "name" | "value" | "unit">): string {
  const both = name === "offset" || name === "z_error" || name === "radius_error";
  return both ? signedLength(value, unit) : measured(value, unit);
}

const COLUMNS: { name: keyof CloudLine; words: string; unit: string }[] = [
  { name: "points", words: words("Points"), unit: "" },
  { name: "used", words: words("Used"), unit: "" },
  { name: "rms_um", words: words("rms"), unit: "µm" },
  { name: "form_um", words: words("Form"), unit: "µm" },
  { name: "angle_arcsec", words: words("Angle"), unit: "″" },
  { name: "z_error_um", words: words("Z error"), unit: "µm" },
  { name: "offset_error_um", words: words("Distance"), unit: "µm" },
  { name: "radius_error_um", words: words("Radius error"), unit: "µm" },
  { name: "centre_error_um", words: words("Centre error"), unit: "µm" },
];

/** The figures against their limits, and cloud by cloud. */
export function tablesOf({ clouds, figures: found }: Shown): TableData[] {
  const known = COLUMNS.filter(({ name }) => clouds.some((cloud) => cloud[name] !== null));
  const number = (value: unknown, unit: string) => (typeof value === "number" ? amount(value, unit ? 1 : 0, unit) : "–");
  return [
    {
      title: words("Figures"),
      head: [words("Figure"), words("Value"), words("U (k = 2)"), words("Limit"), words("Unit"), words("Decision")],
      rows: found.map((f) => [f.title, amount(f.value, 1, f.unit), amount(f.expanded_uncertainty, 1, f.unit), f.limit === null ? "–" : amount(f.limit, 0, f.unit), { unit: f.unit }, WORD[f.decision]]),
      wide: true,
    },
    {
      title: words("Clouds"),
      head: [words("Cloud"), ...known],
      rows: clouds.map((cloud) => [`${cloud.number}`, ...known.map(({ name, unit }) => number(cloud[name], unit))]),
      wide: true,
    },
  ];
}
