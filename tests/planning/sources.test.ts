import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, test } from "vitest";
import { drawnProgram } from "../../src/course/drawn-program.ts";
import { answerOf } from "../../src/course/judge/answer.ts";
import { drawnTask } from "../../src/course/drawn-task.ts";
import { partOfDrawn } from "../../src/course/part-of-drawn.ts";
import { taskSchema } from "../../src/course/task.ts";
import { areaOf } from "../../src/kernel/area/area.ts";
import { difference } from "../../src/kernel/area/clip.ts";
import { at, part as space } from "../../src/kernel/geometry/point.ts";
import { partOfDrawing } from "../../src/planning/part/part-of-drawing.ts";
import { plannedPart } from "../../src/planning/part/planned-part.ts";
import { readDrawing } from "../../src/program/drawing/formats.ts";
import { writeDxf } from "../../src/program/drawing/write-dxf.ts";
import { producedParts } from "../../src/sim/produced-parts.ts";
import { PART_NAMES, partOfTrade } from "./parts.ts";

/** Area that two parts do not share, mm² of the half section. */
type Rings = Parameters<typeof difference>[0];
const unshared = (a: Rings, b: Rings) => areaOf(difference(a, b)) + areaOf(difference(b, a));

describe("a drawing with outside and bore", () => {
  test.each(PART_NAMES)("%s", async (name) => {
    const { part } = plannedPart({ ...partOfTrade(name), unmachinedBehind: false });
    if (!part) throw new Error(name);
    const end = part.outside.segments.at(-1)?.to ?? at(0, 0),
      bottom = part.inside.segments.at(-1)?.to;
    const rear = space.line(end, bottom && bottom.r > 0 ? bottom : at(end.z, 0));
    const segments = [...part.outside.segments, rear, ...part.inside.segments];
    const bytes = new TextEncoder().encode(writeDxf([{ name: "PART", segments }], false, "mm"));
    const drawn = partOfDrawing(await readDrawing({ name: "part.dxf", bytes }), name);
    expect(drawn.part).not.toBeNull();
    const again = drawn.part && plannedPart(drawn.part);
    expect(again?.problems).toEqual([]);
    expect(unshared(again?.part?.rings ?? [], part.rings)).toBeLessThan(0.15);
  });
});

describe("a program", () => {
  const program = (name: string) => readFileSync(join(import.meta.dirname, `../../src/examples/${name}.h`), "utf8");
  test.each(["shaft", "flange", "shoulder", "contour"])("%s", (name) => {
    const answer = answerOf(program(name)),
      made = producedParts(answer.simulation),
      drawn = drawnProgram(answer, made);
    const finished = drawn && partOfDrawn(drawn, { name });
    const planned = finished && plannedPart(finished);
    expect(planned?.problems.filter((p) => p.code !== "front")).toEqual([]);
    const nominal = finished && plannedPart({ ...finished, marks: {} });
    expect(unshared(nominal?.part?.rings ?? [], drawn?.rings ?? [])).toBeLessThan(0.5);
  });
});

const FOLDER = join(import.meta.dirname, "../../src/course/tasks");
const tasks = readdirSync(FOLDER)
  .map((file) => taskSchema.parse(JSON.parse(readFileSync(join(FOLDER, file), "utf8"))))
  .filter((task) => task.part?.outside);

describe("an exercise with a workshop drawing", () => {
  test.each(tasks.map((task) => [task.id, task] as const))("%s", (id, task) => {
    const drawn = drawnTask(task);
    const finished = drawn && partOfDrawn(drawn, { name: id });
    const planned = finished && plannedPart(finished);
    expect(planned?.problems.filter((p) => p.code !== "front")).toEqual([]);
    // Without its marks: their sizes are at the middle of the tolerances.
    const nominal = finished && plannedPart({ ...finished, marks: {} });
    expect(unshared(nominal?.part?.rings ?? [], drawn?.rings ?? [])).toBeLessThan(0.05);
    const { threads = [] } = task.part ?? {};
    const marks = [...(planned?.part?.outside.marks ?? []), ...(planned?.part?.inside.marks ?? [])];
    expect(new Set(marks.flatMap((mark) => mark.thread ?? []))).toEqual(
      new Set(threads.map((thread) => thread.name.replace("×", "x"))),
    );
  });
});
