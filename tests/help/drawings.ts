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

/** Draws a cycle with values; null when they make no contour. */
export function drawn(
  cycle: Cycle,
  values: Numbers,
  active: string | null,
  size: Size,
  given: Given = printedContour,
  said: HelpWords = speech,
): HelpDrawing | null {
  const read = values as Parameters<Cycle["outline"]>[0];
  const outline = cycle.outline(read, given);
  if (outline.contour.length === 0 || outline.issues.some((found) => found.severity === "error")) return null;
  const plan = pointPlan(cycle, read, outline, given);
  return helpDrawing({ params: cycle.params, values, outline, plan, active, size, speech: said });
}

/** Draws a cycle while values are missing. */
export function partlyDrawn(cycle: Cycle, typed: Numbers, active: string | null, size: Size): HelpDrawing | null {
  const made = likelyCompletion(cycle, typed, printedContour);
  if (!made) return null;
  const plan = pointPlan(cycle, made.values, made.outline, printedContour);
  const { values, outline } = made;
  const isBorrowed = cycle.contour === "free";
  return helpDrawing({
    params: cycle.params,
    values: values as Numbers,
    typed,
    isBorrowed,
    outline,
    plan,
    active,
    size,
    speech,
  });
}

/** All marks, including those inside a lens. */
export const flat = (marks: readonly Mark[]): Mark[] =>
  marks.flatMap((m) => (m.kind === "detail" ? [m, ...flat(m.marks)] : [m]));
