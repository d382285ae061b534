import type { OptionField, OptionOffer } from "../api/wire";
import type { PlainId } from "../messages/text";
import { figures } from "../parts/figures";
import { measured } from "../parts/lengths";
import { t } from "../state/language";

/** How the options of the drivers are filled in, where their labels do not say it. */
const HELP: Record<string, PlainId> = {
  base: "ui-help-base",
  chunks: "ui-help-chunks",
  exposure_range_us: "ui-help-exposure-range",
  external_axis: "ui-help-external-axis",
  joint_names: "ui-help-joint-names",
  laser_line: "ui-help-laser-line",
  latency_us: "ui-help-latency",
  line_offset_px: "ui-help-line-offset",
  line_rate_hz: "ui-help-line-rate",
  line_rows: "ui-help-line-rows",
  line_sigma_px: "ui-help-line-sigma",
  packet_size: "ui-help-packet-size",
  region: "ui-help-region",
  setting: "ui-help-setting",
  stamp_at: "ui-help-stamp-at",
  tool: "ui-help-tool",
  trigger: "ui-help-trigger",
  url: "ui-help-url",
};

/** Values of choices in words; those of other drivers are shown as they are. */
const CHOICES: Record<string, PlainId> = {
  "external_axis third": "ui-choice-third-axis",
  "external_axis other": "ui-choice-other-axis",
  "kind joints": "ui-choice-joints",
  "kind pose": "ui-choice-pose",
  "kind tf": "ui-choice-tf",
  "laser_colour red": "ui-choice-red",
  "laser_colour green": "ui-choice-green",
  "laser_colour blue": "ui-choice-blue",
  "line_rows region": "ui-choice-region",
  "line_rows sensor": "ui-choice-sensor",
  "report flange": "ui-choice-flange",
  "report joints": "ui-choice-joints",
  "stamp_at exposure-start": "ui-choice-exposure-start",
  "stamp_at mid-exposure": "ui-choice-mid-exposure",
  "stamp_at exposure-end": "ui-choice-exposure-end",
  "stamp_at frame-end": "ui-choice-frame-end",
  "stamps arrival": "ui-choice-arrival",
  "stamps header": "ui-choice-header",
  "trigger_edge rising": "ui-choice-rising",
  "trigger_edge falling": "ui-choice-falling",
};

export function choiceLabel({ key }: OptionField, value: string): string {
  const id = CHOICES[`${key} ${value}`];
  return id ? t(id) : value;
}

/** What a person needs to know to fill in an option, and what the open device offers for it. */
export function optionHelp({ key, help, unit }: OptionField, offer: OptionOffer | undefined): string {
  const id = HELP[key];
  const texts = [help || (id ? t(id) : "")];
  if (offer?.bounds) {
    const [from, to] = offer.bounds.map((value) => {
      const decimals = Math.abs(value) < 10 && !Number.isInteger(value) ? 2 : 0;
      return unit ? measured(value, unit, decimals) : figures(value, decimals);
    });
    texts.push(t("ui-from-to", { from: from ?? "", to: to ?? "" }));
  }
  if (offer?.largest) texts.push(t("ui-option-at-most", { largest: offer.largest }));
  return texts.filter(Boolean).join(" · ");
}
