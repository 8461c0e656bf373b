import type { Place, Size } from "../camera.ts";
import {
  boxOfLine,
  isWholeIn,
  labelsOverlap,
  movedInto,
  runsThrough,
  sharedArea,
  type LabelBox,
  type StraightLine,
} from "./labels.ts";
import { gridOn, placesOn } from "./sheet-grid.ts";

/** A candidate place of a text: its box, and its lines. */
export interface Spot {
  readonly label: LabelBox;
  readonly lines: readonly StraightLine[];
  /** Prefer the smaller. */
  readonly cost: number;
}

/** A text with its candidate places; of equal cost the first wins. */
export interface Item<S extends Spot> {
  readonly q: string;
  readonly candidates: readonly S[];
  /** Highest cost; above it the text is left out. */
  readonly most?: number;
  /** Shown even if no place is free: where its text covers least. */
  readonly needed?: boolean;
  /** A candidate with its text in another box, for a needed text that would leave the room. */
  readonly moved?: (spot: S, label: LabelBox) => S;
}

/** The chosen place of a text. */
export type Placed<S extends Spot> = S & { readonly item: Item<S>; readonly q: string };

/** Strong lines of the drawing that a text should rather not cover, and the picture they are in. */
export interface Sheet extends Size {
  /** Where texts may be; the whole sheet when left out. */
  readonly room?: LabelBox;
  readonly avoid: readonly Place[];
  /** Areas no text may touch. */
  readonly kept: readonly LabelBox[];
  /** Cost of each crossing of two dimension lines; no cost when left out. */
  readonly crossing?: number;
  /** Cost of each line through a text; no line may run through a text when left out. */
  readonly through?: number;
}

/** Cost of each covered place of a strong line, and the highest number that counts. */
const COVERED = { each: 6, most: 6 } as const;
/** Highest number of crossings that counts. */
const CROSSED = 8;
/** Lines nearer than this run on top of each other, if for more than this length, pixels. */
const ON_TOP = { apart: 1, long: 6 } as const;

/**
 * How much two lines conflict: not at all, once where they cross, or like four crossings where they run on top of each
 * other.
 */
function met([a, b]: StraightLine, [c, d]: StraightLine): 0 | 1 | 4 {
  const [u, v] = [
    { x: b.x - a.x, y: b.y - a.y },
    { x: d.x - c.x, y: d.y - c.y },
  ];
  const long = Math.hypot(u.x, u.y),
    other = Math.hypot(v.x, v.y);
  if (long === 0 || other === 0) return 0;
  const sine = (u.x * v.y - u.y * v.x) / (long * other);
  const along = (p: Place) => ((p.x - a.x) * u.x + (p.y - a.y) * u.y) / long,
    aside = (p: Place) => ((p.x - a.x) * u.y - (p.y - a.y) * u.x) / long;
  if (Math.abs(sine) * other < ON_TOP.apart) {
    if (Math.abs(aside(c)) >= ON_TOP.apart) return 0;
    const shared = Math.min(long, Math.max(along(c), along(d))) - Math.max(0, Math.min(along(c), along(d)));
    return shared > ON_TOP.long ? 4 : shared > -ON_TOP.apart ? 1 : 0;
  }
  // Where the second line passes the first one, as shares of both.
  const share = aside(c) / (aside(c) - aside(d)),
    at = (along(c) + share * (along(d) - along(c))) / long;
  const isOn = (v: number, length: number) => v * length > -ON_TOP.apart && (v - 1) * length < ON_TOP.apart;
  return isOn(share, other) && isOn(at, long) ? 1 : 0;
}

/** The candidate whose text covers least of the taken boxes, moved into the room; of equal ones the cheapest. */
function leastCovering<S extends Spot>(item: Item<S>, room: LabelBox, taken: readonly LabelBox[]): S | undefined {
  const into = (c: S) => {
    const label = item.moved ? movedInto(c.label, room) : c.label,
      far = Math.hypot(label.x - c.label.x, label.y - c.label.y);
    return {
      c: far > 0 && item.moved ? item.moved(c, label) : c,
      covers: taken.reduce((sum, box) => sum + sharedArea(box, label), 0),
      cost: c.cost + far,
    };
  };
  return item.candidates.map(into).toSorted((a, b) => a.covers - b.covers || a.cost - b.cost)[0]?.c;
}

/**
 * Places texts in order, each where it covers no other text and, unless that only costs, no dimension line; a text
 * without a place is left out unless it is needed. Texts already placed stay.
 */
export function arrange<S extends Spot>(
  items: readonly Item<S>[],
  sheet: Sheet,
  standing: readonly Placed<S>[] = [],
): Placed<S>[] {
  const { crossing = 0, through, room = { x: 0, y: 0, width: sheet.width, height: sheet.height } } = sheet;
  const out: Placed<S>[] = [];
  const taken: LabelBox[] = [],
    drawn: StraightLine[] = [];
  const labels = gridOn(sheet, (box: LabelBox) => box),
    lines = gridOn(sheet, boxOfLine),
    covered = placesOn(sheet, sheet.avoid);
  const keep = (box: LabelBox) => {
    taken.push(box);
    labels.put(box);
  };
  const stand = (spot: Placed<S>) => {
    out.push(spot);
    keep(spot.label);
    drawn.push(...spot.lines);
    spot.lines.forEach(lines.put);
  };
  const isTaken = (label: LabelBox) => labels.some(label, (box) => labelsOverlap(box, label));
  const isCrossed = (c: S) =>
    lines.some(c.label, (line) => runsThrough(line, c.label)) ||
    c.lines.some((line) => labels.some(boxOfLine(line), (box) => runsThrough(line, box)));
  const crossings = (c: S) => drawn.reduce((n, l) => n + Math.max(0, ...c.lines.map((line) => met(l, line))), 0);
  const throughTexts = (c: S) =>
    drawn.filter((line) => runsThrough(line, c.label)).length +
    taken.filter((box) => c.lines.some((line) => runsThrough(line, box))).length;
  const costOf = (c: S): number =>
    c.cost +
    Math.min(COVERED.most, covered(c.label)) * COVERED.each +
    (crossing > 0 ? Math.min(CROSSED, crossings(c)) * crossing : 0) +
    (through === undefined ? 0 : throughTexts(c) * through);
  sheet.kept.forEach(keep);
  standing.forEach(stand);
  for (const item of items) {
    let best: S | undefined;
    let least = item.most ?? Infinity;
    for (const c of item.candidates) {
      if (c.cost >= least || !isWholeIn(c.label, room) || isTaken(c.label)) continue;
      if (through === undefined && isCrossed(c)) continue;
      const cost = costOf(c);
      if (cost < least) [best, least] = [c, cost];
    }
    if (item.needed) best ??= leastCovering(item, room, taken);
    if (best) stand({ ...best, item, q: item.q });
  }
  return out;
}
