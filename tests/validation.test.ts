import { describe, expect, test } from "vitest";
import { cycleByNumber } from "../src/cycles/index.ts";
import { contourFrom, type ContourElement } from "../src/kernel/contour.ts";
import type { Code, Issue, Severity } from "../src/kernel/issue.ts";
import type { Tool } from "../src/kernel/tool.ts";
import { axial, diameter, feed, length, toRadius } from "../src/kernel/units.ts";
import { type Draft, exampleDraft, readDraft } from "../src/program/read-draft.ts";
import { shippedTools } from "../src/program/shipped-tools.ts";
import { betterTool } from "../src/program/which-tool.ts";

const at = (x: number, z: number) => ({ z: axial(z), r: toRadius(diameter(x)) });
const line = (x: number, z: number): ContourElement => ({ kind: "line", to: at(x, z) });
const round = (size: number): ContourElement => ({ kind: "round", size });
const shipped = (T: number): Tool => shippedTools.find((tool) => tool.T === T) as Tool;

/** The contour that the manual prints for the free-contour cycle. */
const printed = [line(75, -20), line(50, -20), round(2), line(20, -25), round(2), line(20, 0)];
const usual: Readonly<Record<number, number>> = { 812: 1, 820: 15, 852: 8 };

interface Case {
  readonly change?: Draft;
  readonly tool?: Partial<Tool> & { readonly T: number };
  /** ⌀ and Z of the cycle start. */
  readonly start?: readonly [x: number, z: number];
  readonly contour?: readonly ContourElement[];
}

function check(number: number, { change = {}, tool, start = [75, 2], contour = printed }: Case) {
  const cycle = cycleByNumber(number);
  if (!cycle) throw new Error(`no cycle ${number}`);
  const base = shipped(tool?.T ?? usual[number] ?? 1);
  const built = contourFrom(contour);
  const setting = { tool: { ...base, ...tool }, start: at(start[0], start[1]), feedUnit: "mm/rev" as const, autoFeed: feed(0.25), stock: null };
  const given = { contour: built.segments, start: null };
  const reading = readDraft(cycle, { ...exampleDraft(cycle), ...change });
  const outline = reading.values && cycle.outline(reading.values, given);
  const plan = reading.values && cycle.plan(reading.values, setting, given);
  const issues = [...built.issues, ...reading.issues, ...(outline?.issues ?? []), ...(plan?.issues ?? [])];
  return { cycle, setting, given, reading, plan, issues };
}

const codes = (issues: readonly Issue[]) => issues.map((found) => `${found.code} ${found.at ?? ""}`.trim());
const nearestOf = (found: Issue): number | null => ("nearest" in found.data ? found.data.nearest : null);

/** A rule: a case that trips it, at which field and how hard, and one beside it that does not. */
interface Rule {
  readonly name: string;
  readonly cycle: number;
  readonly code: Code;
  readonly field: string;
  readonly severity: Severity;
  readonly trips: Case;
  readonly passes: Case;
  /** The nearest value named does not go into this field, or depends on others. */
  readonly nearestElsewhere?: true;
}

const finishing = { Q215: "2" };
const rules: readonly Rule[] = [
  { name: "missing", cycle: 812, code: "missing", field: "Q491", severity: "error", trips: { change: { Q491: " " } }, passes: { change: { Q500: "" } } },
  { name: "not a number", cycle: 812, code: "notANumber", field: "Q491", severity: "error", trips: { change: { Q491: "7o" } }, passes: { change: { Q491: "70,5" } } },
  { name: "a sum that cannot be calculated", cycle: 852, code: "badExpression", field: "Q491", severity: "error", trips: { change: { Q491: "75/" } }, passes: { change: { Q491: "140/2+1" } } },
  { name: "a Q parameter without a value", cycle: 820, code: "unknownParameter", field: "Q463", severity: "error", trips: { change: { Q463: "Q5" } }, passes: {} },
  { name: "out of range", cycle: 812, code: "outOfRange", field: "Q463", severity: "error", trips: { change: { Q463: "0" } }, passes: { change: { Q463: "0.5" } } },
  { name: "out of range, where another cycle allows it", cycle: 820, code: "outOfRange", field: "Q463", severity: "error", trips: { change: { Q463: "100" } }, passes: { change: { Q463: "0" } } },
  { name: "not a choice", cycle: 820, code: "notAChoice", field: "Q499", severity: "error", trips: { change: { Q499: "3" } }, passes: { change: { Q499: "1" } } },
  { name: "a diameter below the axis", cycle: 812, code: "diameterNegative", field: "Q493", severity: "error", trips: { change: { Q493: "-10" } }, passes: { change: { Q493: "10" } } },

  { name: "start equals end in X", cycle: 812, code: "startEqualsEnd", field: "Q493", severity: "error", trips: { change: { Q493: "75" } }, passes: { change: { Q493: "60" } } },
  { name: "start equals end in Z", cycle: 812, code: "startEqualsEnd", field: "Q494", severity: "error", trips: { change: { Q494: "0" } }, passes: { change: { Q494: "-20" } } },
  { name: "start equals end in X of a recess", cycle: 852, code: "startEqualsEnd", field: "Q493", severity: "error", trips: { change: { Q493: "75" } }, passes: {}, nearestElsewhere: true },
  { name: "start equals end in Z of a recess", cycle: 852, code: "startEqualsEnd", field: "Q494", severity: "error", trips: { change: { Q494: "-20" } }, passes: {} },

  { name: "start chamfer longer than its element", cycle: 812, code: "elementTooLong", field: "Q502", severity: "error", trips: { change: { Q502: "60" } }, passes: { change: { Q502: "3" } } },
  { name: "start radius longer than its element", cycle: 812, code: "elementTooLong", field: "Q502", severity: "error", trips: { change: { Q501: "2", Q502: "80" } }, passes: { change: { Q501: "2", Q502: "3" } } },
  { name: "end chamfer longer than its element", cycle: 812, code: "elementTooLong", field: "Q504", severity: "error", trips: { change: { Q504: "40" } }, passes: { change: { Q504: "3" } } },
  { name: "end radius longer than its element", cycle: 812, code: "elementTooLong", field: "Q504", severity: "error", trips: { change: { Q503: "2", Q504: "40" } }, passes: { change: { Q503: "2", Q504: "3" } } },
  { name: "without the element its size is free", cycle: 812, code: "elementTooLong", field: "Q502", severity: "error", trips: { change: { Q502: "60" } }, passes: { change: { Q501: "0", Q502: "60" } } },
  { name: "corner radius longer than the face", cycle: 812, code: "elementTooLong", field: "Q500", severity: "error", trips: { change: { Q500: "20" } }, passes: { change: { Q500: "5" } } },
  { name: "start chamfer longer than its wall", cycle: 852, code: "elementTooLong", field: "Q502", severity: "error", trips: { change: { Q502: "40" } }, passes: { change: { Q502: "2" } } },
  { name: "end chamfer longer than its wall", cycle: 852, code: "elementTooLong", field: "Q504", severity: "error", trips: { change: { Q504: "40" } }, passes: { change: { Q504: "2" } } },
  { name: "two corner radii wider than the floor", cycle: 852, code: "cornersTooWide", field: "Q500", severity: "error", trips: { change: { Q500: "5" } }, passes: { change: { Q500: "3" } } },
  { name: "walls that meet above the floor", cycle: 852, code: "wallsMeet", field: "Q495", severity: "error", trips: { change: { Q495: "30" } }, passes: { change: { Q495: "6" } } },
  { name: "second wall that meets the first", cycle: 852, code: "wallsMeet", field: "Q496", severity: "error", trips: { change: { Q496: "30" } }, passes: { change: { Q496: "6" } } },
  { name: "a face that leans past the contour start", cycle: 812, code: "wallsMeet", field: "Q496", severity: "error", trips: { change: { Q494: "-5", Q495: "0", Q496: "40" } }, passes: { change: { Q494: "-40", Q495: "0", Q496: "10" } } },
  { name: "a surface that rises past the face", cycle: 812, code: "wallsMeet", field: "Q495", severity: "error", trips: { change: { Q495: "40" } }, passes: { change: { Q495: "10" } } },

  { name: "corner radius smaller than the insert's", cycle: 812, code: "cornerSmallerThanInsert", field: "Q500", severity: "warning", trips: { change: { Q500: "0.4" } }, passes: { change: { Q500: "0.8" } } },
  { name: "a sharp corner is no slip", cycle: 852, code: "cornerSmallerThanInsert", field: "Q500", severity: "warning", trips: { change: { Q500: "0.1" } }, passes: { change: { Q500: "0" } } },
  { name: "recess narrower than the tool", cycle: 852, code: "recessNarrowerThanTool", field: "Q493", severity: "error", trips: { change: { Q493: "70", Q495: "0", Q496: "0", Q494: "-30", Q500: "0.5" } }, passes: { change: { Q493: "60", Q495: "0", Q496: "0", Q494: "-30", Q500: "0.5" } } },
  { name: "floor narrower than the tool", cycle: 852, code: "recessNarrowerThanTool", field: "Q493", severity: "warning", trips: { change: { Q493: "60", Q500: "0.5" } }, passes: {} },
  { name: "a face that the tool cannot follow", cycle: 812, code: "angleNotFollowed", field: "Q496", severity: "warning", trips: { tool: { T: 1, "T-ANGLE": 80 as Tool["T-ANGLE"] & number } }, passes: { tool: { T: 1 } } },
  { name: "a falling face of the contour", cycle: 820, code: "angleNotFollowed", field: "contour", severity: "warning", trips: { tool: { T: 1 } }, passes: { tool: { T: 15 } }, nearestElsewhere: true },
  { name: "infeed over CUTLENGTH is reduced", cycle: 812, code: "infeedOverCutLength", field: "Q463", severity: "info", trips: { change: { Q463: "10" }, tool: { T: 1, CUTLENGTH: length(4) } }, passes: { change: { Q463: "4" }, tool: { T: 1, CUTLENGTH: length(4) } } },
  { name: "axial infeed over CUTLENGTH is reduced", cycle: 820, code: "infeedOverCutLength", field: "Q463", severity: "info", trips: { change: { Q463: "10" }, tool: { T: 15, CUTLENGTH: length(4) } }, passes: { tool: { T: 15, CUTLENGTH: length(4) } } },
  { name: "Q508 is lowered to what the passes allow", cycle: 852, code: "offsetReduced", field: "Q508", severity: "warning", trips: { change: { Q508: "1" } }, passes: { change: { Q508: "0.1" } } },
  { name: "0.1 mm per pass over 80 % of the effective width", cycle: 852, code: "offsetOverLimit", field: "Q508", severity: "error", trips: { change: { Q463: "0.5" } }, passes: { change: { Q463: "2" } }, nearestElsewhere: true },
  { name: "Q480 on the wrong side", cycle: 820, code: "limitOnWrongSide", field: "Q480", severity: "warning", trips: { change: { Q479: "1", Q480: "80", Q482: "-60" } , start: [90, 2] }, passes: { change: { Q479: "1", Q480: "30", Q482: "-60" }, start: [90, 2] } },
  { name: "Q482 on the wrong side", cycle: 820, code: "limitOnWrongSide", field: "Q482", severity: "warning", trips: { change: { Q479: "1", Q480: "0", Q482: "-25" }, start: [75, -30] }, passes: { change: { Q479: "1", Q480: "0", Q482: "-10" } } },
  { name: "Q482 above the whole contour", cycle: 820, code: "limitOnWrongSide", field: "Q482", severity: "warning", trips: { change: { Q479: "1", Q480: "0", Q482: "1" } }, passes: { change: { Q479: "1", Q480: "0", Q482: "-1" } } },
  { name: "limits that are off are not looked at", cycle: 820, code: "limitOnWrongSide", field: "Q480", severity: "warning", trips: { change: { Q479: "1", Q480: "80", Q482: "-60" }, start: [90, 2] }, passes: { change: { Q479: "0", Q480: "80", Q482: "-60" }, start: [90, 2] } },
  { name: "a tool that cannot cut sideways", cycle: 852, code: "toolCannotCutSideways", field: "tool", severity: "warning", trips: { tool: { T: 8, TYPE: "RECESS" } }, passes: { tool: { T: 8 } } },
  { name: "a tool on the wrong side", cycle: 812, code: "toolUnfit", field: "tool", severity: "error", trips: { tool: { T: 5 } }, passes: { tool: { T: 2 } } },
  { name: "a tool whose flanks are not known", cycle: 812, code: "flanksNotChecked", field: "tool", severity: "info", trips: { tool: { T: 11, TYPE: "ROUGH", RS: length(0.8) } }, passes: { tool: { T: 1 } } },

  { name: "start point inside the area", cycle: 812, code: "startInArea", field: "start.x", severity: "warning", trips: { start: [60, -10] }, passes: { start: [75, 2] } },
  { name: "start point below the contour start", cycle: 820, code: "startBelowContour", field: "start.z", severity: "info", trips: { start: [80, -30] }, passes: { start: [80, 2] } },
  { name: "start point below the opening of the recess", cycle: 852, code: "startBelowContour", field: "start.z", severity: "info", trips: { start: [75, -30] }, passes: { start: [75, -15] } },
  { name: "start point inside the finishing envelope", cycle: 812, code: "startInsideEnvelope", field: "start.x", severity: "warning", trips: { change: finishing, start: [50, 1] }, passes: { change: finishing, start: [80, 5] } },
  { name: "depth over CUTLENGTH", cycle: 852, code: "depthOverCutLength", field: "Q494", severity: "warning", trips: { tool: { T: 8, CUTLENGTH: length(20) } }, passes: { tool: { T: 8, CUTLENGTH: length(31) } } },

  { name: "contour without two points", cycle: 820, code: "contourTooShort", field: "contour", severity: "error", trips: { contour: [line(75, 0)] }, passes: {} },
  { name: "rounding too large for its neighbours", cycle: 820, code: "cornerElementTooLong", field: "contour", severity: "error", trips: { contour: [line(75, -20), line(50, -20), round(100), line(20, -25), line(20, 0)] }, passes: {}, nearestElsewhere: true },
  { name: "rounding without a neighbour", cycle: 820, code: "cornerElementAlone", field: "contour", severity: "error", trips: { contour: [round(2), ...printed] }, passes: {} },
  { name: "arc radius too small", cycle: 820, code: "arcTooSmall", field: "contour", severity: "error",
    trips: { contour: [line(75, -20), { kind: "radius", to: at(20, 0), radius: 5, turn: "cw" }] },
    passes: { contour: [line(75, -20), { kind: "radius", to: at(20, 0), radius: 40, turn: "cw" }] }, nearestElsewhere: true },
];

describe.each(rules.map((rule) => [`${rule.name} (${rule.cycle} ${rule.code})`, rule] as const))("%s", (_, rule) => {
  test("is found", () => {
    const { issues } = check(rule.cycle, rule.trips);
    expect(codes(issues)).toContain(`${rule.code} ${rule.field}`);
    expect(issues.find((i) => i.code === rule.code && i.at === rule.field)?.severity).toBe(rule.severity);
  });

  test("is not found beside it", () => {
    expect(codes(check(rule.cycle, rule.passes).issues)).not.toContain(`${rule.code} ${rule.field}`);
  });

  test("names a value that works", () => {
    const found = check(rule.cycle, rule.trips).issues.find((i) => i.code === rule.code && i.at === rule.field);
    const nearest = found ? nearestOf(found) : null;
    if (nearest === null || rule.nearestElsewhere) return;
    const mended = check(rule.cycle, { ...rule.trips, change: { ...rule.trips.change, [rule.field]: String(nearest) } });
    expect([nearest, codes(mended.issues)]).not.toEqual([nearest, expect.arrayContaining([`${rule.code} ${rule.field}`])]);
  });
});

describe("the printed examples", () => {
  test.each([812, 820, 852])("%i has no error with its usual tool", (number) => {
    const { issues, plan } = check(number, {});
    expect(issues.filter((found) => found.severity === "error")).toEqual([]);
    expect(plan?.moves.length).toBeGreaterThan(0);
  });
});

describe("a tool that cannot make the contour", () => {
  test.each([[812, 5, 1], [820, 1, 15], [852, 1, 8]])("cycle %i with tool %i: tool %i is the usual one", (number, T, usualOne) => {
    const { cycle, reading, given, setting } = check(number, { tool: { T } });
    expect(reading.values && betterTool(cycle, reading.values, given, setting, shippedTools)?.T).toBe(usualOne);
  });

  test.each([[820, 1], [820, 5], [852, 1], [852, 10], [812, 5], [812, 8]])("cycle %i with tool %i: one that can is named", (number, T) => {
    const { cycle, reading, given, setting } = check(number, { tool: { T } });
    if (!reading.values) throw new Error("the example reads");
    const better = betterTool(cycle, reading.values, given, setting, shippedTools);
    expect(better).not.toBeNull();
    const best = check(number, { tool: { T: better?.T ?? 0 } });
    expect(codes(best.issues.filter((found) => found.severity === "error"))).toEqual([]);
    expect(codes(best.issues)).not.toContain("angleNotFollowed contour");
  });
});
