import { cycleByNumber } from "../src/cycles/index.ts";
import { never } from "../src/kernel/never.ts";
import { exampleJob, newRow, type ContourRow, type Job } from "../src/program/job.ts";

/** ⌀ and Z of the ends, mm; how many waves lie between them and how deep they are. */
const FROM = { x: 200, z: -30 };
const TO = { x: 20, z: 0 };
const WAVES = 12;
const DEPTH = 0.8;

/** A waved contour, cut across the axis: after the start point lines and arcs in turn, `elements` of them. */
function waves(elements: number): ContourRow[] {
  return Array.from({ length: elements + 1 }, (_, i): ContourRow => {
    const part = i / elements;
    const x = (FROM.x + (TO.x - FROM.x) * part).toFixed(3);
    const z = (FROM.z + (TO.z - FROM.z) * part + DEPTH * Math.sin(2 * Math.PI * WAVES * part)).toFixed(3);
    return i > 0 && i % 2 === 0
      ? newRow(`e${i}`, { kind: "CR", x, z, r: "2", turn: i % 4 === 0 ? "cw" : "ccw" })
      : newRow(`e${i}`, { x, z });
  });
}

/** The job of a printed example. */
export function printedExample(cycle: number): Job {
  const known = cycleByNumber(cycle);
  return known ? exampleJob(known) : never("a cycle that is not in the catalogue", cycle);
}

/** A free contour of many elements on a blank that contains it. */
export const longContour = (cycle: number, elements: number): Job => ({
  ...printedExample(cycle),
  name: "WAVES",
  contour: waves(elements),
  blank: { outside: "200", bore: "", length: "80", allowance: "2" },
  start: { x: "204", z: "2" },
});
