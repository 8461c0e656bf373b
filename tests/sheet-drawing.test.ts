import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import * as fc from "fast-check";
import { describe, expect, test } from "vitest";
import { exampleJob } from "../src/program/job/job.ts";
import { cuttingCycles } from "../src/cycles/index.ts";
import { ncLabels } from "../src/i18n/nc-labels.ts";
import { parse } from "../src/nc/parse.ts";
import { printJob } from "../src/program/job/print-job.ts";
import { run } from "../src/program/run/run.ts";
import { shippedTools } from "../src/program/tools/shipped-tools.ts";
import { simulate } from "../src/sim/simulate.ts";
import { labelsOverlap } from "../src/view/dimensions/labels.ts";
import { factorOf } from "../src/view/drawing/scales.ts";
import { partDrawing, type PartDrawing } from "../src/view/drawing/part-drawing.ts";
import type { SetUpWords } from "../src/view/drawing/print-sizes.ts";
import { forSetter, type DrawnSetUp } from "../src/view/drawing/setter.ts";

const plain = (n: number) => String(Math.round(n * 1000) / 1000);
const words: SetUpWords = {
  diameter: (d) => `⌀${plain(d)}`,
  position: plain,
  thread: (diameter, lead) => `${diameter}×${plain(lead)}`,
  length: plain,
};
const ROOM = { width: 124, height: 96 };

function drawnWork(text: string): DrawnSetUp {
  const made = run(parse(text), { tools: shippedTools, rapid: 10_000 });
  return {
    blank: made.blank,
    finished: simulate(made).final,
    contours: made.operations.map(({ plan: { contour, thread } }) => ({
      segments: contour,
      ...(thread && { thread: { lead: thread.lead, starts: thread.starts } }),
    })),
  };
}

/** The faults of a drawing: overlapping texts, or texts or lines outside it. */
function faultsOf({ shapes, texts, width, height }: PartDrawing): readonly string[] {
  const over = texts.flatMap((a, i) =>
    texts
      .slice(i + 1)
      .filter((b) => labelsOverlap(a.box, b.box))
      .map((b) => `${a.text} over ${b.text}`),
  );
  const out = texts.filter(
    ({ box }) => box.x < 0 || box.y < 0 || box.x + box.width > width || box.y + box.height > height,
  );
  const isOutside = ([, x = "", y = ""]: readonly string[]) =>
    Number(x) < 0 || Number(y) < 0 || Number(x) > width || Number(y) > height;
  const lines = shapes.filter(({ d }) => [...d.matchAll(/[ML](-?[\d.]+) (-?[\d.]+)/g)].some(isOutside));
  return [...over, ...out.map(({ text }) => `${text} outside`), ...lines.map(({ role }) => `${role} outside`)];
}

const examples = cuttingCycles.map((cycle) => {
  const job = exampleJob(cycle);
  return [String(cycle.number), printJob(job, ncLabels("en"))] as const;
});
const programs = ["flange", "shaft"].map(
  (name) => [name, readFileSync(join("src", "examples", `${name}.h`), "utf8")] as const,
);

describe("no dimension over another, none outside", () => {
  test.each([...examples, ...programs])("%s", (_, text) => {
    const work = drawnWork(text);
    for (const room of [ROOM, { width: 124, height: 60 }, { width: 70, height: 96 }]) {
      const drawing = partDrawing(forSetter(work, words), room);
      expect(drawing).not.toBe(null);
      expect(drawing && faultsOf(drawing)).toEqual([]);
      expect(drawing && drawing.height).toBeLessThanOrEqual(room.height);
    }
  });

  test("any size in any room", () => {
    const works = [...examples.slice(0, 4), ...programs].map(([, text]) => drawnWork(text));
    const scaled = (work: DrawnSetUp, k: number): DrawnSetUp => {
      const ring = (points: DrawnSetUp["blank"][number]) =>
        points.map(({ z, r }) => ({ z: z * k, r: r * k }) as (typeof points)[number]);
      return { blank: work.blank.map(ring), finished: work.finished.map(ring), contours: [] };
    };
    fc.assert(
      fc.property(
        fc.constantFrom(...works),
        fc.double({ min: 0.03, max: 30, noNaN: true }),
        fc.double({ min: 62, max: 190, noNaN: true }),
        fc.double({ min: 45, max: 150, noNaN: true }),
        (work, k, width, height) => {
          const drawing = partDrawing(forSetter(scaled(work, k), words), { width, height });
          expect(drawing && faultsOf(drawing)).toEqual([]);
        },
      ),
      { numRuns: 60 },
    );
  });
});

describe("the content of a drawing", () => {
  const drawing = (name: string) => {
    const found = programs.find(([own]) => own === name);
    const made = partDrawing(forSetter(drawnWork(found?.[1] ?? ""), words), ROOM);
    if (!made) throw new Error(name);
    return made;
  };

  test("the flange: its diameters, its shoulders, its blank in brackets", () => {
    const { texts, scale, omitted } = drawing("flange");
    expect(scale).toEqual({ paper: 1, part: 2 });
    expect(omitted).toBe(0);
    const said = texts.map(({ text }) => text);
    for (const text of ["(⌀100)", "(⌀24)", "⌀80", "⌀62", "⌀40", "-58", "-40", "-32", "-4", "0", "(2)", "(-88)", "90"])
      expect(said).toContain(text);
    expect(texts.filter(({ turned }) => turned)).toHaveLength(7);
  });

  test("the shaft: its threads with their lead", () => {
    expect(drawing("shaft").texts.map(({ text }) => text)).toEqual(
      expect.arrayContaining(["⌀60×1.5", "⌀42.376×1.5", "⌀66.5", "-26"]),
    );
  });

  test("to scale: shoulders are as far apart on paper as their dimensions state", () => {
    const made = drawing("flange");
    const begin = (of: string) => {
      const thin = made.shapes
        .filter(({ role }) => role === "thin")
        .map(({ d }) => [...d.matchAll(/(-?[\d.]+) (-?[\d.]+)/g)]);
      const text = made.texts.find((each) => each.text === of && each.turned);
      const own = thin.find(
        (points) => points.length === 3 && Math.abs(Number(points[2]?.[1]) - (text?.at.x ?? 0)) < 0.02,
      );
      return Number(own?.[0]?.[1]);
    };
    expect(begin("-4") - begin("-58")).toBeCloseTo(54 * factorOf(made.scale), 1);
  });

  test("an empty drawing says so", () => {
    expect(partDrawing(forSetter({ blank: [], finished: [], contours: [] }, words), ROOM)).toBe(null);
  });
});

test("every golden program has a drawing without a fault, or nothing to draw", () => {
  const folder = join("tests", "programs");
  for (const name of readdirSync(folder).filter((each) => each.endsWith(".h"))) {
    const made = partDrawing(forSetter(drawnWork(readFileSync(join(folder, name), "utf8")), words), ROOM);
    expect([name, made ? faultsOf(made) : []]).toEqual([name, []]);
  }
});
