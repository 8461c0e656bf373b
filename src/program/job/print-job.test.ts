import { describe, expect, test } from "vitest";
import { cuttingCycles, cycleByNumber } from "../../cycles/index.ts";
import { ncLabels } from "../../i18n/nc-labels.ts";
import { parse } from "../../nc/parse.ts";
import { print } from "../../nc/program.ts";
import { withOperation } from "../edits/added-operation.ts";
import { exampleJob, type SetJob } from "./job.ts";
import {
  LEGACY_OUTPUT,
  isNcOutput,
  nameOfOutput,
  NC_OUTPUT_NAMES,
  NC_OUTPUTS,
  type NcOutput,
} from "../machine/nc-output.ts";
import { outputIn } from "../edits/output-in.ts";
import { printJob } from "./print-job.ts";
import { proposedOperation, usualSurface } from "./proposed-operation.ts";
import { surfacesOf } from "./stock-surface.ts";
import { run } from "../run/run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";

const labels = ncLabels("en");
const jobOf = (cycle: number, given: Partial<SetJob> = {}): SetJob => {
  const found = cycleByNumber(cycle);
  if (!found) throw new Error(`no cycle ${cycle}`);
  return { ...exampleJob(found), ...given };
};
const bare = (text: string) => text.split(/\r?\n/).map((line) => line.replace(/^\d+ +/, "").replaceAll(/ {2,}/g, " "));
/** The blocks around the call: approach after the tool call, and retraction to the end. */
const ways = (job: SetJob) => {
  const lines = bare(printJob(job, labels));
  const cycle = lines.findIndex((line) => line.startsWith(`CYCL DEF ${job.cycle}`)),
    call = lines.indexOf("CYCL CALL");
  return {
    there: [...lines.slice(0, cycle), ...lines.slice(cycle + 1, call)].filter((line) => line.startsWith("L ")),
    back: lines.slice(call + 1, lines.findIndex((line) => line === `M${job.output.end}`) + 1),
  };
};

describe("what a program does for its machine", () => {
  const own: NcOutput = { ...NC_OUTPUTS.manual, spindleOn: 403, spindleOff: 405, end: 2 };
  test.each<[string, NcOutput, string, readonly string[]]>([
    ["as in the manual", NC_OUTPUTS.manual, "M303", ["L Z+52 R0 FMAX", "M305", "M30"]],
    ["main spindle", NC_OUTPUTS.mainSpindle, "M3", ["L Z+52 R0 FMAX", "M5", "M30"]],
    ["the builder's own", own, "M403", ["L Z+52 R0 FMAX", "M405", "M2"]],
    ["to the limit of travel", { ...own, retract: "limit" }, "M403", ["M140 MB MAX", "M405", "M2"]],
    ["as works before it", LEGACY_OUTPUT, "M303", ["L Z+52 R0 FMAX", "M30"]],
  ])("%s", (_, output, on, back) => {
    const found = ways(jobOf(812, { output }));
    expect(found.there.at(-1)).toBe(`L X+75 Y+0 Z+2 FMAX ${on}`);
    expect(found.back).toEqual(back);
  });

  test("block numbers, line ends and the case of the name are those of its file transfer", () => {
    const text = printJob(jobOf(812, { name: "Part 7a", output: NC_OUTPUTS.transfer }), labels);
    expect(text.startsWith("BEGIN PGM PART_7A MM\r\nBLK FORM")).toBe(true);
    expect(text.replaceAll("\r\n", "")).not.toMatch(/[\r\n]/);
    expect(text).not.toMatch(/^\d/m);
  });

  test("each preset is known by its name, a change of it is the builder's own", () => {
    expect(NC_OUTPUT_NAMES.map((name) => nameOfOutput(NC_OUTPUTS[name]))).toEqual(NC_OUTPUT_NAMES);
    expect(nameOfOutput(own)).toBeNull();
  });

  test.each<[string, unknown]>([
    ["nothing", null],
    ["half of it", { spindleOn: 3 }],
    ["a function that is none", { ...own, spindleOn: 1000 }],
    ["a part of a function", { ...own, spindleOff: 5.5 }],
    ["another end", { ...own, end: 0 }],
    [
      "another line end",
      {
        ...own,
        newLine: "\r",
      },
    ],
  ])("%s is no setting", (_, raw) => expect(isNcOutput(raw)).toBe(false));
});

describe("the way to the start point and back", () => {
  const blank = { outside: "90", bore: "30", length: "80", allowance: "1.5" };
  test.each([
    // Straight where free, along the axis in a bore, elsewhere across it at a height that clears every shoulder.
    [
      "beside the blank",
      { x: "91.5", z: "-22.5" },
      ["L X+111.5 Z+51.5 R0 FMAX", "L X+91.5 Y+0 Z-22.5 FMAX M303"],
      ["L Z+51.5 R0 FMAX"],
    ],
    ["in front", { x: "44.3", z: "3" }, ["L X+110 Z+53 R0 FMAX", "L X+44.3 Y+0 Z+3 FMAX M303"], ["L Z+53 R0 FMAX"]],
    [
      "lower than the outside",
      { x: "61.7", z: "-22.5" },
      ["L X+110 Z+51.5 R0 FMAX", "L Z-22.5 FMAX", "L X+61.7 Y+0 Z-22.5 FMAX M303"],
      ["L X+110 R0 FMAX", "L Z+51.5 R0 FMAX"],
    ],
    [
      "in the bore",
      { x: "28", z: "-12" },
      ["L X+110 Z+51.5 R0 FMAX", "L X+28 FMAX", "L X+28 Y+0 Z-12 FMAX M303"],
      ["L Z+51.5 R0 FMAX"],
    ],
  ])("%s", (_, start, there, back) => {
    const found = ways(jobOf(811, { blank, start }));
    expect(found.there).toEqual(there);
    expect(found.back).toEqual([...back, "M305", "M30"]);
  });

  test("with a tailstock across the axis, also in front", () => {
    const clamping = { kind: "chuckOutside", words: { QUILL: "40", TIP: "0" } } as const;
    const found = ways(jobOf(811, { blank, start: { x: "90", z: "3" }, clamping }));
    expect(found.there).toEqual(["L X+110 Z+53 R0 FMAX", "L Z+3 FMAX", "L X+90 Y+0 Z+3 FMAX M303"]);
    expect(found.back).toEqual(["L X+110 R0 FMAX", "L Z+53 R0 FMAX", "M305", "M30"]);
  });
});

describe("every text of the app obeys the rules that it checks", () => {
  test.each(cuttingCycles.map((cycle) => [cycle.number, cycle] as const))("%i", (_, cycle) => {
    const text = printJob(exampleJob(cycle), labels);
    expect(/VCONST:OFF/.test(text)).toBe(cycle.group === "thread");
    const blocks = bare(text);
    expect(blocks[blocks.indexOf("M30") - 1]).toBe("M305");
    expect(text).not.toMatch(/Q460=-/);
  });

  test("a thread behind cuts at a constant surface speed is cut at a constant speed", () => {
    const cycle = cycleByNumber(831);
    if (!cycle) throw new Error("no cycle 831");
    const before = run(parse(printJob(jobOf(811), labels)), { tools: shippedTools, rapid: 10_000 });
    expect(before.operations[0]?.spindle?.kind).toBe("surface");
    const surface = usualSurface(cycle, surfacesOf(before.blank, "outside"));
    if (!surface) throw new Error("no cylinder");
    const { job: made } = proposedOperation(cycle, {
      stock: before.blank,
      surface,
      before: before.operations,
      contour: [],
      start: { x: "", z: "" },
    });
    expect(made.spindle.mode).toBe("constant");
  });
});

describe("an operation added to a program", () => {
  const program = (on: string) =>
    parse(
      printJob(jobOf(811, { name: "A" }), labels)
        .replace("M303", on)
        .replace("M305", "M8"),
    );
  test.each([
    ["M3", 3, 5],
    ["M4", 4, 5],
    ["M304", 304, 305],
    ["M303", 303, 305],
  ])("starts and stops the spindle as the program does: %s", (on, start, stop) =>
    expect(outputIn(program(on), NC_OUTPUTS.transfer)).toMatchObject({ spindleOn: start, spindleOff: stop }),
  );

  test("stops it only behind the last operation", () => {
    const two = withOperation(program("M3"), jobOf(821), labels);
    expect(bare(print(two)).filter((line) => line === "M5")).toHaveLength(1);
    const three = bare(print(withOperation(two, jobOf(812), labels, { behind: 0 })));
    expect(three.filter((line) => line === "M5")).toHaveLength(1);
    expect(three.lastIndexOf("M5")).toBeGreaterThan(three.lastIndexOf("CYCL CALL"));
  });
});
