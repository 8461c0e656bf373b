import type { Mark } from "./marks.ts";
import type { Place } from "../camera.ts";

/** A box on the screen, pixels. */
export interface Box {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** Where one dimension could stand: its marks, the box of its text, and lines no other text may cover. */
export interface Candidate {
  readonly marks: readonly Mark[];
  readonly label: Box;
  readonly lines: readonly Box[];
  /** Prefer the smaller. */
  readonly cost: number;
}

/** One dimension with its possible places; the first of equal cost wins. */
export interface Item {
  readonly q: string;
  readonly candidates: readonly Candidate[];
  /** Left out rather than placed at a higher cost. */
  readonly most?: number;
}

export interface Placed {
  readonly q: string;
  readonly marks: readonly Mark[];
  readonly label: Box;
}

/** Text sizes, pixels: grey and active. Boxes are counted with the larger, so that nothing moves when one becomes active. */
export const SIZE = { quiet: 12, strong: 14, caption: 12 } as const;

/** Width of a text in the figures' font (every letter 0.6 of its size; signs from other fonts a whole). */
export const textWidth = (text: string, size: number): number =>
  [...text].reduce((sum, c) => sum + (c.codePointAt(0)! > 0x2100 && c !== "−" && c !== "≤" ? 1 : 0.6), 0) * size;

/** The box of a text about its middle, with a pixel of air. */
export function textBox(middle: Place, text: string, turn: 0 | -90, size: number = SIZE.strong): Box {
  const long = textWidth(text, size) + 4, tall = size + 2;
  const [width, height] = turn === 0 ? [long, tall] : [tall, long];
  return { x: middle.x - width / 2, y: middle.y - height / 2, width, height };
}

/** Whether two boxes share any area. */
export const overlap = (a: Box, b: Box): boolean =>
  a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;

/** The box round two places, a pixel thick at least. */
export const lineBox = (a: Place, b: Place): Box => ({
  x: Math.min(a.x, b.x) - 0.5, y: Math.min(a.y, b.y) - 0.5, width: Math.abs(a.x - b.x) + 1, height: Math.abs(a.y - b.y) + 1,
});

const within = (b: Box, width: number, height: number) =>
  b.x >= 0 && b.y >= 0 && b.x + b.width <= width && b.y + b.height <= height;

/** Strong lines of the drawing that a text should rather not cover, and the picture they are in. */
export interface Sheet {
  readonly width: number;
  readonly height: number;
  readonly avoid: readonly Place[];
  /** Areas no text may touch. */
  readonly kept: readonly Box[];
}

const covered = (b: Box, places: readonly Place[]) =>
  places.reduce((n, p) => n + (p.x > b.x && p.x < b.x + b.width && p.y > b.y && p.y < b.y + b.height ? 1 : 0), 0);

/** Places dimensions in order, each where its text covers no other text nor dimension line; what finds no place is left out. */
export function arrange(items: readonly Item[], sheet: Sheet): Placed[] {
  const out: Placed[] = [];
  const labels: Box[] = [...sheet.kept];
  const lines: Box[] = [];
  for (const item of items) {
    let best: Candidate | null = null;
    let least = item.most ?? Infinity;
    for (const c of item.candidates) {
      if (!within(c.label, sheet.width, sheet.height)) continue;
      if (labels.some((l) => overlap(l, c.label)) || lines.some((l) => overlap(l, c.label))) continue;
      if (c.lines.some((line) => labels.some((l) => overlap(l, line)))) continue;
      const cost = c.cost + Math.min(6, covered(c.label, sheet.avoid)) * 6;
      if (cost < least) [best, least] = [c, cost];
    }
    if (!best) continue;
    labels.push(best.label);
    lines.push(...best.lines);
    out.push({ q: item.q, marks: best.marks, label: best.label });
  }
  return out;
}
