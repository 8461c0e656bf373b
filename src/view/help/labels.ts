import type { Mark } from "./marks.ts";
import type { Place } from "../camera.ts";

/** A box on the screen, pixels. */
export interface LabelBox {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** A candidate place of a dimension: its marks, the box of its text, and lines that no other text may cover. */
export interface Candidate {
  readonly marks: readonly Mark[];
  readonly label: LabelBox;
  readonly lines: readonly LabelBox[];
  /** Prefer the smaller. */
  readonly cost: number;
}

/** A dimension with its candidate places; of equal cost the first wins. */
export interface Item {
  readonly q: string;
  readonly candidates: readonly Candidate[];
  /** Highest cost; above it the dimension is left out. */
  readonly most?: number;
}

export interface Placed {
  readonly item: Item;
  readonly q: string;
  readonly marks: readonly Mark[];
  readonly label: LabelBox;
  /** Boxes of its lines. */
  readonly lines: readonly LabelBox[];
}

/** Text sizes, pixels: grey and active. Boxes use the larger one, so that nothing moves when a text becomes active. */
export const SIZE = { quiet: 12, strong: 14, caption: 12 } as const;

/** Width of a text in the figures' font (every letter 0.6 of its size; signs from other fonts a whole). */
export const textWidth = (text: string, size: number): number =>
  [...text].reduce((sum, c) => sum + (c.codePointAt(0)! > 0x2100 && c !== "−" && c !== "≤" ? 1 : 0.6), 0) * size;

/** The box of a text about its middle, with a pixel of air. */
export function textBox(middle: Place, text: string, turn: 0 | -90, size: number = SIZE.strong): LabelBox {
  const long = textWidth(text, size) + 4,
    tall = size + 2;
  const [width, height] = turn === 0 ? [long, tall] : [tall, long];
  return { x: middle.x - width / 2, y: middle.y - height / 2, width, height };
}

/** Whether two boxes share any area. */
export const labelsOverlap = (a: LabelBox, b: LabelBox): boolean =>
  a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;

/** The box round two places, a pixel thick at least. */
export const lineBox = (a: Place, b: Place): LabelBox => ({
  x: Math.min(a.x, b.x) - 0.5,
  y: Math.min(a.y, b.y) - 0.5,
  width: Math.abs(a.x - b.x) + 1,
  height: Math.abs(a.y - b.y) + 1,
});

const within = (b: LabelBox, width: number, height: number) =>
  b.x >= 0 && b.y >= 0 && b.x + b.width <= width && b.y + b.height <= height;

/** Strong lines of the drawing that a text should rather not cover, and the picture they are in. */
export interface Sheet {
  readonly width: number;
  readonly height: number;
  readonly avoid: readonly Place[];
  /** Areas no text may touch. */
  readonly kept: readonly LabelBox[];
  /** Cost of each crossing of two dimension lines; no cost when left out. */
  readonly crossing?: number;
}

const covered = (b: LabelBox, places: readonly Place[]) =>
  places.reduce((n, p) => n + (p.x > b.x && p.x < b.x + b.width && p.y > b.y && p.y < b.y + b.height ? 1 : 0), 0);

/**
 * How much two lines conflict: not at all, once where they cross, or like four crossings where they run on top of each
 * other.
 */
function met(a: LabelBox, b: LabelBox): 0 | 1 | 4 {
  if (!labelsOverlap(a, b)) return 0;
  const upright = a.width <= 2 && b.width <= 2 && Math.min(a.y + a.height, b.y + b.height) - Math.max(a.y, b.y) > 6;
  const level = a.height <= 2 && b.height <= 2 && Math.min(a.x + a.width, b.x + b.width) - Math.max(a.x, b.x) > 6;
  return upright || level ? 4 : 1;
}

/** A candidate whose text is moved the shortest way to where it is fully on the sheet, right of a left edge. */
function movedInside(c: Candidate, left: number, { width, height }: Sheet): Candidate {
  const inside = (at: number, long: number, low: number, high: number) => Math.max(low, Math.min(at, high - long)) - at;
  const [dx, dy] = [inside(c.label.x, c.label.width, left, width), inside(c.label.y, c.label.height, 0, height)];
  const marks = c.marks.map((m): Mark =>
    m.kind === "text" ? { ...m, place: { x: m.place.x + dx, y: m.place.y + dy } } : m,
  );
  return {
    ...c,
    marks,
    label: { ...c.label, x: c.label.x + dx, y: c.label.y + dy },
    cost: c.cost + Math.hypot(dx, dy),
  };
}

/**
 * The place of a dimension that must be shown although it fits nowhere: its text is moved onto the sheet, clear of the
 * kept areas on its left.
 */
export function forced(item: Item, sheet: Sheet): Placed | null {
  const left = Math.max(0, ...sheet.kept.filter((b) => b.x <= 0).map((b) => b.x + b.width));
  const cheapest = item.candidates.map((c) => movedInside(c, left, sheet)).sort((a, b) => a.cost - b.cost)[0];
  return cheapest ? { item, q: item.q, marks: cheapest.marks, label: cheapest.label, lines: cheapest.lines } : null;
}

/**
 * Places dimensions in order, each where its text covers no other text or dimension line; a dimension without a place
 * is left out. Dimensions already placed stay.
 */
export function arrange(items: readonly Item[], sheet: Sheet, standing: readonly Placed[] = []): Placed[] {
  const out: Placed[] = [...standing];
  const labels: LabelBox[] = [...sheet.kept, ...standing.map((p) => p.label)];
  const lines: LabelBox[] = standing.flatMap((p) => p.lines);
  for (const item of items) {
    let best: Candidate | null = null;
    let least = item.most ?? Infinity;
    for (const c of item.candidates) {
      if (c.cost >= least || !within(c.label, sheet.width, sheet.height)) continue;
      if (labels.some((l) => labelsOverlap(l, c.label)) || lines.some((l) => labelsOverlap(l, c.label))) continue;
      if (c.lines.some((line) => labels.some((l) => labelsOverlap(l, line)))) continue;
      const crossed = sheet.crossing
        ? lines.reduce((n, l) => n + Math.max(0, ...c.lines.map((line) => met(l, line))), 0)
        : 0;
      const cost =
        c.cost + Math.min(6, covered(c.label, sheet.avoid)) * 6 + Math.min(8, crossed) * (sheet.crossing ?? 0);
      if (cost < least) [best, least] = [c, cost];
    }
    if (!best) continue;
    labels.push(best.label);
    lines.push(...best.lines);
    out.push({ item, q: item.q, marks: best.marks, label: best.label, lines: best.lines });
  }
  return out;
}
