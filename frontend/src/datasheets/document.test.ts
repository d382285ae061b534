import { describe, expect, it } from "vitest";

import type { Message } from "../messages/text";
import { copyOf, documentOf, edgesOf, isFilled, listed, placeOf, valuesOf } from "./document";
import { FORMS, type FormName, fieldsOf } from "./forms";
import { problemText } from "./wording";

const BLOCK = {
  format: "crenel/object",
  version: 1,
  name: "Block",
  serial_number: "B-7",
  edges_x_mm: [-24, -15.25, 6, 19],
  front_y_mm: -13,
  back_y_mm: 13,
  crest_z_mm: 15,
  floor_z_mm: 0,
  base_z_mm: -12,
  standard_uncertainty_mm: 0.002,
};
const JOINT = { a_mm: 1.5, alpha_deg: 90, d_mm: 0, theta_deg: -30, sign: -1, limits_deg: [-170, 160] };
const ARM = {
  format: "crenel/arm",
  version: 1,
  name: "Arm",
  convention: "dh-modified",
  base: { z_mm: 3 },
  joints: [1, 2, 3, 4, 5].map((n) => ({ name: `J${n}`, ...JOINT, encoder_sd_deg: 0.001, error: { x_mm: n } })),
  tip: { x_mm: 0, y_mm: 0, z_mm: 120, diameter_mm: 6 },
};
const SPHERE = { format: "crenel/nominal", version: 1, shape: "sphere", radius_mm: 12.7, limits: { rms: 20 } };
const BOARD = {
  format: "crenel/object",
  version: 1,
  kind: "chessboard",
  name: "Board",
  inner_corners: [9, 6],
  square_mm: 10,
  standard_uncertainty_mm: 0.05,
};
const STEPS = {
  format: "crenel/length-standard",
  version: 1,
  kind: "step-gauge",
  name: "Steps",
  valid_until: "2028-03-12",
  expansion_per_c: 0.0000115,
  lengths: [20, 40.0003].map((length_mm) => ({ length_mm, standard_uncertainty_um: 0.1 })),
};
const SENSOR = {
  format: "crenel/sensor",
  version: 1,
  name: "S",
  width_px: 640,
  height_px: 480,
  stripe_axis: "v",
  selected: { colour: "red" },
};
const ROBOT = { format: "crenel/arm", version: 1, name: "R", convention: "pose" };
const DOCUMENTS: [FormName, Record<string, unknown>][] = [
  ["block", BLOCK],
  ["arm", ARM],
  ["sphere", SPHERE],
  ["chessboard", BOARD],
  ["robot", ROBOT],
  ["step-gauge", STEPS],
  ["sensor", SENSOR],
];

describe("a document in the fields", () => {
  it.each(DOCUMENTS)("comes back as it was, with what no field of %s holds", (name, document) => {
    expect(documentOf(name, valuesOf(name, document), document)).toEqual(document);
  });
  it("of an identified arm loses what was identified once a parameter is changed", () => {
    const arm = { ...ARM, identification: { rms_um: 3 } };
    const values = valuesOf("arm", arm);
    expect(documentOf("arm", { ...values, name: "B" }, arm).identification).toBeDefined();
    expect(documentOf("arm", { ...values, "joints.1.d_mm": "2" }, arm).identification).toBeUndefined();
  });
  it("of a copy has the numbers, and nothing that belongs to one unit", () => {
    const { identification, ...copy } = copyOf({ ...ARM, serial_number: "A-1", identification: {} }, "Copy");
    expect([copy.name, copy.serial_number, identification]).toEqual(["Copy", undefined, undefined]);
    expect(valuesOf("arm", copy)).toEqual({ ...valuesOf("arm", ARM), name: "Copy" });
    expect(JSON.stringify(copy)).not.toContain("error");
    expect(copyOf(ARM, "Copy")).toEqual({ ...ARM, name: "Copy" });
  });
  it("shows the diameter of a sphere, the expansion in µm/(m·K), and a sign where none is stated", () => {
    expect(valuesOf("sphere", SPHERE).radius_mm).toBe("25.4");
    expect(valuesOf("step-gauge", STEPS).expansion_per_c).toBe("11.5");
    const { sign, ...joint } = JOINT;
    expect(valuesOf("arm", { ...ARM, joints: [joint] })["joints.0.sign"]).toBe("1");
  });
});

describe("what was typed", () => {
  it.each([
    ["-24, -15; -7\n-1", ["-24", "-15", "-7", "-1"]],
    ["-24,-15,6 +8", ["-24", "-15,6", "+8"]],
    ["1,5 2,5", ["1,5", "2,5"]],
    ["", []],
  ])("%j is a list of numbers", (text, expected) => {
    expect(listed(text)).toEqual(expected);
  });
  it("is sent as it is where it is no number, so that the station names it", () => {
    const values = { ...valuesOf("block", BLOCK), crest_z_mm: "1,2,3", edges_x_mm: "1; x; 3" };
    const document = documentOf("block", values);
    expect([document.crest_z_mm, document.edges_x_mm]).toEqual(["1,2,3", [1, "x", 3]]);
  });
  it("leaves out what is empty", () => {
    expect(documentOf("robot", { name: "R" })).toEqual(ROBOT);
    expect(isFilled("robot", { name: "R" })).toBe(true);
    expect(isFilled("block", { name: "R" })).toBe(false);
  });
  it("as widths makes edges from 0 on", () => {
    expect(edgesOf([9.1, 8.2, 6])).toEqual([0, 9.1, 17.3, 23.3]);
  });
});

const mostIs = (limit: string) => ({ message_id: "value-must-be-at-most", values: { limit } });
const named = (name: string) => ({ message_id: "field-name", values: { name } });
const limits = { message_id: "limits-deg-must-ascend", values: { limits: named("limits_deg"), name: "J3" } };
const tooLong = { message_id: "sentence", values: { text: mostIs("300") } };
const marker = {
  message_id: "marker-mm-less-than-square-mm",
  values: { marker: named("marker_mm"), square: named("x") },
};

describe("what the station says of a document", () => {
  it.each<[FormName, Message, string | undefined, string]>([
    ["arm", limits, undefined, "“Limits” of J3 must ascend"],
    ["charuco", marker, undefined, "“Side of a marker” must be less than x"],
    ["sphere", tooLong, "radius_mm", "It must be at most 600\u00a0mm."],
    ["sphere", tooLong, undefined, "It must be at most 300."],
  ])("stands in the words of the form of %s", (name, said, key, words) => {
    const field = FORMS[name].fields.find((one) => one.key === key);
    expect(problemText(said, name, field)).toBe(words);
  });
});

it("a problem stands beside its field", () => {
  const { fields } = FORMS.block;
  expect(placeOf("edges_x_mm.3", fields)).toBe("edges_x_mm");
  expect(placeOf("crest_z_mm", fields)).toBe("crest_z_mm");
  expect(placeOf("", fields)).toBe("");
  expect(placeOf("joints.2.limits_deg", fieldsOf("arm", FORMS.arm.first))).toBe("joints.2.limits_deg.0");
  expect(placeOf("tip", FORMS.arm.fields)).toBe("tip.x_mm");
});
