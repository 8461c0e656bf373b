import { afterEach, expect, test } from "vitest";
import { cuttingCycles } from "../../../cycles/index.ts";
import { exampleJob, UNSET } from "../../../program/job/job.ts";
import { shippedList } from "../../../program/tools/tool-list.ts";
import { changeSettings } from "../../base/settings/settings.ts";
import { openFirstWork, changeJob, setBundle } from "../../document/store.ts";
import { toolRecord } from "../../document/tool-store.ts";
import { shopOf } from "../../document/work-tools.ts";
import { openedProgram, presentProgram, withOtherText } from "./sides.ts";
import { asProgram } from "../../document/printed.ts";

const [cycle] = cuttingCycles;
if (!cycle) throw new Error("the catalogue is empty");
const withRs = (RS: string) => shippedList.map((row) => ({ ...row, cells: { ...row.cells, RS } }));
const radius = (work: Parameters<typeof shopOf>[0]) => shopOf(work).table.tools[0]?.RS;

afterEach(() => {
  openFirstWork(null, null);
  toolRecord.replace(shippedList);
  changeSettings({ control: "TNC 640" });
});

test("a saved work is compared with its own tools and settings, else with those of the device", () => {
  toolRecord.replace(withRs("0.7"));
  openFirstWork({ ...exampleJob(cycle), tools: withRs("0.3") }, "open");
  const carried = asProgram({ ...exampleJob(cycle), tools: withRs("0.9"), control: "TNC7" });
  expect([radius(carried), shopOf(carried).control]).toEqual([0.9, "TNC7"]);
  const bare = asProgram(exampleJob(cycle));
  expect([radius(bare), shopOf(bare).control]).toEqual([0.7, "TNC 640"]);
  const program = asProgram({ name: "A.h", text: "0 BEGIN PGM A MM", encoding: "utf-8", tools: withRs("1.1") });
  expect(radius(program)).toBe(1.1);
});

test("a cycle without a chosen tool calls one of its own tools, not one of the open work", () => {
  const unset = { ...exampleJob(cycle), ...UNSET };
  const numbered = shippedList.map((row) => ({ ...row, cells: { ...row.cells, T: String(Number(row.cells.T) + 60) } }));
  openFirstWork({ ...unset, tools: numbered }, "open");
  const called = (text: string) => Number(/TOOL CALL (\d+)/.exec(text)?.[1]);
  const [present, bare] = [presentProgram()?.text ?? "", asProgram(unset).text];
  expect(called(present)).toBe(called(bare) + 60);
});

test("the open work as it was opened, and another text for it, use its present tools and control", () => {
  openFirstWork({ ...exampleJob(cycle), tools: withRs("0.3") }, "open");
  changeJob((job) => ({ ...job, parameters: { Q5: "7.3" } }));
  setBundle({ tools: withRs("0.5"), control: "TNC7" });
  const opened = openedProgram();
  expect(opened && [radius(opened), shopOf(opened).control]).toEqual([0.5, "TNC7"]);
  const present = presentProgram();
  const other = present && withOtherText(present, "0 BEGIN PGM B MM");
  expect(other && [radius(other), shopOf(other).control, other.text]).toEqual([0.5, "TNC7", "0 BEGIN PGM B MM"]);
  setBundle({});
  const bare = openedProgram();
  expect(bare && radius(bare)).toBe(shopOf({}).table.tools[0]?.RS);
});
