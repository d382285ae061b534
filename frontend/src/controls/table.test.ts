import { afterEach, expect, test } from "vitest";

import { message, quantity, signedQuantity } from "../messages/text";
import { chooseLanguage } from "../state/language";
import { chooseUnits } from "../state/units";
import { toCsv } from "./csv";
import { displayedCell, displayedHead, type TableData } from "./table";

const TABLE: TableData = {
  title: "ui-poses",
  head: ["ui-pose", { title: "ui-deviation", unit: "µm" }, { symbol: "t", unit: "mm" }, { symbol: "x" }],
  rows: [
    [message("ui-pose-n", { n: 3 }), quantity(-12345.6, "µm", 1), { unit: "µm" }, ""],
    [message("ui-left-out-reason", { reason: 'a "bad" one' }), signedQuantity(0.5, "µm", 1), "R2", ""],
  ],
};

afterEach(async () => {
  await chooseLanguage("en");
  chooseUnits("metric");
});

test("a file is in English, with decimal points and in the station's units, whatever is displayed", async () => {
  await chooseLanguage("de");
  chooseUnits("inch");
  expect(toCsv([TABLE, TABLE]).split("\n\n")[0]).toBe(
    ["Poses", 'Pose,"Deviation, µm","t, mm",x', "Pose 3,-12345.6,µm,", '"excluded: a ""bad"" one",0.5,R2,'].join("\n"),
  );
});

test("the page has the same in its language and units", async () => {
  await chooseLanguage("de");
  expect(TABLE.head.map(displayedHead)).toEqual(["Pose", "Abweichung, µm", "t, mm", "x"]);
  expect(TABLE.rows[0]?.map(displayedCell)).toEqual(["Pose 3", "\u221212\u2009345,6", "µm", ""]);
  chooseUnits("inch");
  expect(TABLE.head.map(displayedHead)).toEqual(["Pose", "Abweichung, µin", "t, in", "x"]);
  expect(TABLE.rows[1]?.map(displayedCell)).toEqual(['ausgeschlossen: a "bad" one', "+20", "R2", ""]);
});
