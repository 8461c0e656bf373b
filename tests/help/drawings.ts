import { cuttingCycles } from "../../src/cycles/index.ts";
import { likelyCompletion } from "../../src/cycles/completions.ts";
import type { Cycle, Given } from "../../src/cycles/define.ts";
import { firstValues } from "../../src/cycles/first-values.ts";
import { pointPlan } from "../../src/cycles/point-plan.ts";
import { contourFrom } from "../../src/kernel/contour/contour.ts";
import { axial, diameter, toRadius } from "../../src/kernel/units.ts";
import type { Size } from "../../src/view/camera.ts";
import type { Numbers, HelpWords } from "../../src/view/help/lettering.ts";
import type { Mark } from "../../src/view/help/marks.ts";
import { helpDrawing, type HelpDrawing } from "../../src/view/help/picture.ts";

/** English lettering, independent of the page's texts. */
export const speech: HelpWords = {
  number: (value, decimals) => String(Number(value.toFixed(decimals))),
  element: ["none", "chamfer", "radius"],
  reserved: "(no function)",
  notToScale: "not to scale",
};

const lineTo = (x: number, z: number) => ({ kind: "line", to: { z: axial(z), r: toRadius(diameter(x)) } }) as const;
const round = (size: number) => ({ kind: "round", size }) as const;

/** The contour printed for the free-contour cycle. */
export const printedContour: Given = {
  contour: contourFrom([lineTo(75, -20), lineTo(50, -20), round(2), lineTo(20, -25), round(2), lineTo(20, 0)]).segments,
  start: null,
};

/** The cycles with a help picture. */
export const cycles: readonly Cycle[] = cuttingCycles;
export const exampleOf = (cycle: Cycle): Numbers => firstValues(cycle);

/** A picture of the same values, for any open prompt, size and lettering. */
export type Pictured = (active: string | null, size: Size, speech?: HelpWords) => HelpDrawing;

/** How a cycle with values is drawn; null when they make no contour. */
export function pictured(cycle: Cycle, values: Numbers, given: Given = printedContour): Pictured | null {
  const read = values as Parameters<Cycle["outline"]>[0];
  const outline = cycle.outline(read, given);
  if (outline.contour.length === 0 || outline.issues.some((found) => found.severity === "error")) return null;
  const plan = pointPlan(cycle, read, outline, given);
  return (active, size, said = speech) =>
    helpDrawing({ params: cycle.params, values, outline, plan, active, size, speech: said });
}

/** How a cycle is drawn while values are missing. */
export function partlyPictured(cycle: Cycle, typed: Numbers): Pictured | null {
  const made = likelyCompletion(cycle, typed, printedContour);
  if (!made) return null;
  const plan = pointPlan(cycle, made.values, made.outline, printedContour);
  const values = made.values as Numbers,
    { outline } = made;
  const known = { params: cycle.params, values, typed, isBorrowed: cycle.contour === "free", outline, plan };
  return (active, size, said = speech) => helpDrawing({ ...known, active, size, speech: said });
}

/** All marks, including those inside a lens. */
export const flat = (marks: readonly Mark[]): Mark[] =>
  marks.flatMap((m) => (m.kind === "detail" ? [m, ...flat(m.marks)] : [m]));
