import type { Place, Size } from "../camera.ts";
import { labelsOverlap, type LabelBox } from "./labels.ts";
import type { Mark } from "../help/marks.ts";
import { boxesOn, placesOn } from "./sheet-grid.ts";

/** A candidate place of a text: its box, and boxes of its lines that no other text may cover. */
export interface Spot {
  readonly label: LabelBox;
  readonly lines: readonly LabelBox[];
  /** Prefer the smaller. */
  readonly cost: number;
}

/** A candidate place of a dimension, with its marks. */
export interface Candidate extends Spot {
  readonly marks: readonly Mark[];
}

/** A text with its candidate places; of equal cost the first wins. */
export interface Item<S extends Spot = Candidate> {
  readonly q: string;
  readonly candidates: readonly S[];
  /** Highest cost; above it the text is left out. */
  readonly most?: number;
  /** Shown even if no place is free: where its text covers least. */
  readonly needed?: boolean;
}

/** The chosen place of a text. */
export type Placed<S extends Spot = Candidate> = S & { readonly item: Item<S>; readonly q: string };

const within = (b: LabelBox, { width, height }: Size) =>
  b.x >= 0 && b.y >= 0 && b.x + b.width <= width && b.y + b.height <= height;

/** Strong lines of the drawing that a text should rather not cover, and the picture they are in. */
export interface Sheet extends Size {
  readonly avoid: readonly Place[];
  /** Areas no text may touch. */
  readonly kept: readonly LabelBox[];
  /** Cost of each crossing of two dimension lines; no cost when left out. */
  readonly crossing?: number;
}

/** Cost of each covered place of a strong line, and the highest number that counts. */
const COVERED = { each: 6, most: 6 } as const;
/** Highest number of crossings that counts. */
const CROSSED = 8;

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

const shared = (a: LabelBox, b: LabelBox): number =>
  Math.max(0, Math.min(a.x + a.width, b.x + b.width) - Math.max(a.x, b.x)) *
  Math.max(0, Math.min(a.y + a.height, b.y + b.height) - Math.max(a.y, b.y));

/** The candidate whose text covers least of the taken boxes; of equal ones the cheapest. */
function leastCovering<S extends Spot>(candidates: readonly S[], taken: readonly LabelBox[]): S | undefined {
  const covers = (c: S) => taken.reduce((sum, box) => sum + shared(box, c.label), 0);
  return candidates
    .map((c) => ({ c, covers: covers(c) }))
    .toSorted((a, b) => a.covers - b.covers || a.c.cost - b.c.cost)[0]?.c;
}

/**
 * Places texts in order, each where it covers no other text or dimension line; a text without a place is left out
 * unless it is needed. Texts already placed stay.
 */
export function arrange<S extends Spot>(
  items: readonly Item<S>[],
  sheet: Sheet,
  standing: readonly Placed<S>[] = [],
): Placed<S>[] {
  const out = [...standing];
  const taken = [...sheet.kept, ...standing.map((p) => p.label)],
    drawn = standing.flatMap((p) => p.lines);
  const labels = boxesOn(sheet, taken),
    lines = boxesOn(sheet, drawn),
    covered = placesOn(sheet, sheet.avoid);
  const costOf = (c: S): number => {
    const crossed = sheet.crossing
      ? drawn.reduce((n, l) => n + Math.max(0, ...c.lines.map((line) => met(l, line))), 0)
      : 0;
    return (
      c.cost +
      Math.min(COVERED.most, covered(c.label)) * COVERED.each +
      Math.min(CROSSED, crossed) * (sheet.crossing ?? 0)
    );
  };
  for (const item of items) {
    let best: S | undefined;
    let least = item.most ?? Infinity;
    for (const c of item.candidates) {
      if (c.cost >= least || !within(c.label, sheet)) continue;
      if (labels.isTaken(c.label) || lines.isTaken(c.label) || c.lines.some(labels.isTaken)) continue;
      const cost = costOf(c);
      if (cost < least) [best, least] = [c, cost];
    }
    if (item.needed) best ??= leastCovering(item.candidates, taken);
    if (!best) continue;
    taken.push(best.label);
    drawn.push(...best.lines);
    labels.take(best.label);
    best.lines.forEach(lines.take);
    out.push({ ...best, item, q: item.q });
  }
  return out;
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
  return cheapest ? { ...cheapest, item, q: item.q } : null;
}
