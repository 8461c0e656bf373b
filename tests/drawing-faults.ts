import { labelsOverlap, type LabelBox } from "../src/view/dimensions/labels.ts";
import type { PartDrawing } from "../src/view/drawing/part-drawing.ts";

/** A box without the margin around its letters. */
const letters = ({ x, y, width, height }: LabelBox): LabelBox => ({
  x: x + 0.8,
  y: y + 0.8,
  width: width - 1.6,
  height: height - 1.6,
});

type Spot = readonly [x: number, y: number];

/** The straight lines of a path, without its curves. */
const straights = (d: string): (readonly [Spot, Spot])[] =>
  [...d.matchAll(/M[^MQaZ]+/g)].flatMap(([line]) => {
    const numbers = [...line.matchAll(/-?\d+(?:\.\d+)?/g)].map(([n]) => Number(n));
    const spots = Array.from({ length: Math.floor(numbers.length / 2) }, (_, i): Spot => [
      numbers[2 * i] ?? 0,
      numbers[2 * i + 1] ?? 0,
    ]);
    return line.includes("H") ? [] : spots.slice(1).map((to, i) => [spots[i] ?? to, to] as const);
  });

/** Whether a line crosses a box, sampled in small steps. */
function crosses([[ax, ay], [bx, by]]: readonly [Spot, Spot], { x, y, width, height }: LabelBox): boolean {
  const steps = Math.ceil(Math.hypot(bx - ax, by - ay) / 0.2);
  return Array.from({ length: steps + 1 }, (_, i) => i / Math.max(1, steps)).some((share) => {
    const [px, py] = [ax + share * (bx - ax), ay + share * (by - ay)];
    return px > x && px < x + width && py > y && py < y + height;
  });
}

/** The faults of a drawing as a print. */
export function faultsOf({ texts, shapes, width, height }: PartDrawing): string[] {
  const over = texts.flatMap((a, i) =>
    texts
      .slice(i + 1)
      .filter((b) => labelsOverlap(a.box, b.box))
      .map((b) => `${a.text} over ${b.text}`),
  );
  const out = texts.filter(({ box: b }) => b.x < 0 || b.y < 0 || b.x + b.width > width || b.y + b.height > height);
  const lines = shapes
    .filter(({ role }) => role === "thin" || role === "outline" || role === "edge")
    .flatMap(({ role, d }) => straights(d).map((line) => ({ role, line })));
  const through = texts.flatMap((text) =>
    lines
      .filter(({ line }) => crosses(line, letters(text.box)))
      .map(({ role }) => `a ${role} line through ${text.text}`),
  );
  return [...over, ...out.map(({ text }) => `${text} outside`), ...through];
}
