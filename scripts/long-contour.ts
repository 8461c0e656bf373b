import { cycleByNumber } from "../src/cycles/index.ts";
import { never } from "../src/kernel/never.ts";
import { exampleJob, newRow, type ContourRow, type SetJob } from "../src/program/job/job.ts";

/** ⌀ and Z of the outer and the inner end, mm; number and depth of the waves between them. */
const RIM = { x: 200, z: -30 };
const NOSE = { x: 20, z: 0 };
const WAVES = 12;
const DEPTH = 0.8;

/** A waved contour: after the start point, lines and arcs in turn, `elements` of them. */
function waves(elements: number, from: typeof RIM, to: typeof RIM): ContourRow[] {
  return Array.from({ length: elements + 1 }, (_, i): ContourRow => {
    const part = i / elements;
    const x = (from.x + (to.x - from.x) * part).toFixed(3);
    const z = (from.z + (to.z - from.z) * part + DEPTH * Math.sin(2 * Math.PI * WAVES * part)).toFixed(3);
    return i > 0 && i % 2 === 0
      ? newRow(`e${i}`, { kind: "CR", x, z, r: "2", turn: i % 4 === 0 ? "cw" : "ccw" })
      : newRow(`e${i}`, { x, z });
  });
}

/** The job of a printed example. */
export function printedExample(cycle: number): SetJob {
  const known = cycleByNumber(cycle);
  return known ? exampleJob(known) : never("a cycle that is not in the catalogue", cycle);
}

/** A free contour of many elements on a blank that contains it, in the cutting direction of its cycle. */
export const longContour = (cycle: number, elements: number): SetJob => ({
  ...printedExample(cycle),
  name: "WAVES",
  contour: cycleByNumber(cycle)?.group === "longitudinal" ? waves(elements, NOSE, RIM) : waves(elements, RIM, NOSE),
  blank: { outside: "200", bore: "", length: "80", allowance: "2" },
  start: { x: "204", z: "2" },
});
