import { describe, expect, test } from "vitest";
import { cycleByNumber } from "../../cycles/index.ts";
import { ncLabels } from "../../i18n/nc-labels.ts";
import { parse } from "../../nc/parse.ts";
import { print } from "../../nc/program.ts";
import { grooveNamed } from "../../kernel/contour/relief-groove.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { diameter } from "../../kernel/units.ts";
import { verdictOf } from "../../report/verdict.ts";
import { producedParts } from "../../sim/produced-parts.ts";
import { simulate } from "../../sim/simulate.ts";
import { emptyProgram } from "../job/empty-program.ts";
import { readRows } from "../job/contour-rows.ts";
import { readDraft } from "../job/read-draft.ts";
import { jobFor, tipAtCall } from "../job/requested-job.ts";
import { undercutsNamed } from "../job/undercut-name.ts";
import { run } from "../run/run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";
import { standardUndercutTools } from "../iso-codes/standard-undercut-tools.ts";
import { readList, shippedList } from "../tools/tool-list.ts";
import { rankTools, type ToolFit } from "../tools/which-tool.ts";
import { withHandOperation, withOperation } from "./added-operation.ts";
import { placeOf, reachingFirst, shouldersOf, undercutCut, undercutJob } from "./undercut-operation.ts";

const shop = { tools: shippedTools, rapid: 10_000 };

/** A step of 20 mm at the front of a blank: a shaft of 40, or a bore of 36 over one of 24. */
function stepped(site: "outside" | "inside") {
  const cycle = cycleByNumber(812);
  if (!cycle) throw new Error("no cycle");
  const [from, to] = site === "outside" ? [60, 40] : [24, 36];
  const blank = { outside: "60", bore: site === "outside" ? "0" : "24", length: "70", allowance: "0" };
  const program = parse(emptyProgram("A", blank));
  const corner = (d: number, z: number) => ({ diameter: diameter(d), z: z as never });
  const job = jobFor(
    cycle,
    {
      site,
      shape: "step",
      from: corner(from, 0),
      to: corner(to, -20),
      angle: 0,
      pitch: 1,
      contour: null,
      allowance: 0,
    },
    null,
  );
  return withOperation(program, { ...job, tool: site === "outside" ? 2 : 5 }, ncLabels("en"), { title: "STEP" });
}

const standard = readList(standardUndercutTools(shippedList).map((cells, i) => ({ id: `u${i}`, cells }))).table.tools;

function undercut(site: "outside" | "inside", typed: string) {
  const before = stepped(site);
  const stock = simulate(run(before, shop)).final;
  const [shoulder] = shouldersOf(stock, site);
  if (!shoulder) throw new Error("no shoulder");
  const place = placeOf(shoulder);
  const [named] = undercutsNamed(typed, place).sizes;
  const job = named && undercutJob(named, { place, z: shoulder.z, stock });
  const cycle = job && cycleByNumber(job.cycle);
  const values = job && cycle ? readDraft(cycle, job.drafts[job.cycle] ?? {}).values : null;
  if (!job || !cycle || !values) throw new Error(`no job for ${typed}`);
  const given = { start: tipAtCall(job), contour: readRows(job.contour).contour.segments };
  const setting = { start: tipAtCall(job), feedUnit: "mm/rev", autoFeed: null, stock: null } as const;
  const ranked = (tools: readonly Tool[]) =>
    reachingFirst(rankTools(cycle, values, given, setting, tools), named)[0] as ToolFit;
  const own = ranked(shippedTools);
  const best = own.makesContour ? own : ranked(standard);
  if (!best.makesContour) throw new Error(`no tool for ${typed}`);
  const called = { ...job, tool: best.tool.T };
  const path = named && undercutCut(named, called);
  const next = path
    ? withHandOperation(before, { ...called, start: path.start }, path.cut, { title: typed })
    : withOperation(before, called, ncLabels("en"), { title: typed });
  const made = run(parse(print(next)), { ...shop, tools: [...shippedTools, ...standard] });
  const simulation = simulate(made);
  return { tool: best.tool.NAME, made, simulation, points: producedParts(simulation).flat() };
}

const sizeOf = (typed: string) => typed.slice(2).split("x").map(Number) as [number, number];

describe("an undercut as an operation", () => {
  test("finds the shoulder behind the radius that the nose leaves", () => {
    const stock = simulate(run(stepped("outside"), shop)).final;
    const [shoulder] = shouldersOf(stock, "outside");
    expect(shoulder?.z).toBeCloseTo(-20, 2);
    expect(shoulder && placeOf(shoulder)).toEqual({ diameter: 40, isInside: false });
  });

  test.each([
    ["outside", "E 0.6x0.3", "DNMG-55-R04", 39.4],
    ["outside", "E 0.8x0.3", "DNMG-55-R04", 39.4],
    ["outside", "F 0.8x0.3", "VBMT160404-SVHBR", 39.4],
    ["outside", "F 1x0.2", "VBMT160404-SVHBR", 39.6],
    ["outside", "F 0.4x0.2", "VBMT160402-SVHBR", 39.6],
    ["outside", "DIN 76-A 1.5", "DNMG-55-R04", 37.7],
    ["outside", "DIN 76-B 1.5", "DNMG-55-R04", 37.7],
    ["outside", "E 0.6x0.3 z0.2", "DNMG-55-R04", 39],
    ["inside", "E 0.6x0.3", "BORE-DCMT-55-R04", 36.6],
    ["inside", "F 0.6x0.3", "BORE-VBMT110304-A20S", 36.6],
    // The floor is at nominal + 0.5: a bore of 36 is M36 × 1.5.
    ["inside", "DIN 76-D 1.5", "BORE-DCMT-55-R04", 36.5],
  ] as const)("%s %s is cut and proved", (site, typed, name, floor) => {
    const { made, simulation, tool, points } = undercut(site, typed);
    expect(tool).toBe(name);
    expect(made.issues.filter(({ issue }) => issue.severity !== "info")).toEqual([]);
    expect(simulation.findings).toEqual([]);
    expect(verdictOf(made, simulation).verdict).toBe("proved");
    const at = points.filter(({ z }) => z < -17 && z > -20.5).map(({ r }) => 2 * r);
    const deepest = site === "outside" ? Math.min(...at) : Math.max(...at.filter((d) => d < 45));
    expect(deepest).toBeCloseTo(floor, 2);
    const behindFace =
      -20 -
      Math.min(
        ...points
          .filter(({ r }) => 2 * r > 26 && 2 * r < 46)
          .map(({ z }) => z)
          .filter((z) => z > -21),
      );
    expect(behindFace).toBeCloseTo(typed.startsWith("F") ? (grooveNamed("F", ...sizeOf(typed))?.t2 ?? 0) : 0, 2);
  });

  test("none where the face is too low or UDC has no such form", () => {
    const place = { diameter: diameter(40), isInside: false };
    const job = (typed: string, d = 40) => {
      const [named] = undercutsNamed(typed, place).sizes;
      return named && undercutJob(named, { place: { ...place, diameter: diameter(d) }, z: -20, stock: [] });
    };
    expect(job("E 0.6x0.3")?.contour.map(({ kind }) => kind)).toEqual(["L", "L", "UDC", "L"]);
    expect(job("G 0.4x0.2")).toBeNull();
    expect(job("DIN 76-A 6", 8)).toBeNull();
  });
});
