import { producedParts } from "../../sim/produced-parts.ts";
import { at, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { diameter, radius, toDiameter, toRadius } from "../../kernel/units.ts";
import { scanCrossings } from "../../sim/scan.ts";
import type { TaskSize, SizeKind } from "../task.ts";
import { firstStepInto } from "./difference.ts";
import type { Answer, TaskMark } from "./judgement.ts";

/** Half the length of the strip in which the move that made a size is found, mm. */
const STRIP = 0.05;

/** The point at which a size is measured on a half section, and its value there, mm; null without material. */
export function sizeOn(
  stock: readonly Ring[],
  kind: SizeKind,
  where: number,
): { readonly value: number; readonly place: Pt } | null {
  if (kind === "face") {
    const r = toRadius(diameter(where));
    const z = scanCrossings(stock, "z", [r])[0]?.at(-1);
    return z === undefined ? null : { value: z, place: at(z, r) };
  }
  const found = scanCrossings(stock, "r", [where])[0] ?? [];
  const r = kind === "diameter" ? found.at(-1) : found[0];
  return r === undefined ? null : { value: toDiameter(radius(r)), place: at(where, r) };
}

/** The strip between a measured and a nominal size: the move that cut there made the size. */
function between({ kind, nominal, at: where }: TaskSize, { z, r }: Pt): Ring {
  const [low, high, left, right] =
    kind === "face"
      ? [r - STRIP, r + STRIP, Math.min(z, nominal), Math.max(z, nominal)]
      : [
          Math.min(r, toRadius(diameter(nominal))),
          Math.max(r, toRadius(diameter(nominal))),
          where - STRIP,
          where + STRIP,
        ];
  return [at(left, low), at(right, low), at(right, high), at(left, high)];
}

/** Whether each size of the made part is within its limits. */
export function sizeMarks(sizes: readonly TaskSize[], answer: Answer): TaskMark[] {
  return sizes.map((size, index) => {
    const found = sizeOn(producedParts(answer.simulation), size.kind, size.at);
    if (!found) return { rule: "size", passed: false, size: index };
    const off = found.value - size.nominal;
    const passed = off >= size.lower - SAME && off <= size.upper + SAME;
    const mark: TaskMark = { rule: "size", passed, value: found.value, size: index, place: found.place };
    return passed ? mark : { ...mark, ...firstStepInto([between(size, found.place)], answer) };
  });
}
