import { boxAround } from "../../kernel/area/box.ts";
import { intersection } from "../../kernel/area/clip.ts";
import { at, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import { BESIDE, isHollow, isOutmost, spanAt } from "./body.ts";
import { AIR } from "./lengths.ts";
import { widthOf } from "./paper.ts";
import type { DrawnContent } from "./part-drawing.ts";
import { printFeatures } from "./print-features.ts";
import { makerSizes, type Across, type PrintedPart, type PrintWords } from "./print-sizes.ts";

/** Nearer values are one, mm. */
const ONE = 0.005;
/** The stub of the blank drawn behind the part, as a share of the part's length, and its minimum, mm. */
const STUB = { share: 0.14, least: 4 } as const;

/** Whether a level line at a radius from `z` to `end` stays clear of material, outside of the part or in its bore. */
function isFree(rings: readonly Ring[], r: number, z: number, end: number, isBore: boolean): boolean {
  const stops = [z, end, ...rings.flat().map((p) => p.z)]
    .filter((v) => v >= Math.min(z, end) && v <= Math.max(z, end))
    .sort((a, b) => a - b);
  return stops.every((stop, i) => {
    const next = stops[i + 1];
    if (next === undefined || next - stop < ONE) return true;
    const span = spanAt(rings, (stop + next) / 2);
    return !span || (isBore ? span.low >= r - ONE : span.high <= r + ONE);
  });
}

/** Start of the drawn part of the blank: a stub behind the turned part, if the blank is longer. */
function shownFrom(work: PrintedPart): number {
  const box = boxAround([...work.blank]);
  const turned = [...work.outside, ...work.bore].flatMap((s) => [s.from.z, s.to.z]);
  if (turned.length === 0) return box.left;
  const end = Math.min(...turned),
    front = Math.max(...turned);
  const stub = end - Math.max(STUB.least, STUB.share * (front - end));
  return box.left < stub - STUB.least ? stub : box.left;
}

/**
 * A part for the person who makes it, as a workshop drawing: above the axis in section if it is hollow, below it from
 * outside; diameters beside it, lengths from Z0 below, notes with leaders above. Null without a part.
 */
export function forMaker(work: PrintedPart, words: PrintWords): DrawnContent | null {
  if (work.rings.length === 0) return null;
  const whole = boxAround([...work.rings]),
    from = shownFrom(work);
  const broken = from > whole.left + ONE ? from : null;
  const frame: Ring = [
    at(from, -1),
    at(whole.right + 1, -1),
    at(whole.right + 1, whole.high + 1),
    at(from, whole.high + 1),
  ];
  const body = broken === null ? work.rings : intersection(work.rings, [frame]);
  const box = boxAround([...body]);
  const sizes = makerSizes(work, words, { from: box.left, isBroken: broken !== null });
  const sideOf = (a: Across): "right" | "left" | "above" => {
    if (isFree(body, a.r, a.right, box.right, a.isBore)) return "right";
    return isFree(body, a.r, a.left, box.left, a.isBore) && (broken === null || !a.isBore) ? "left" : "above";
  };
  const sided = sizes.across.map((a) => ({ a, side: sideOf(a) }));
  // Features hidden from outside get their lengths above, in the section.
  const breaks = [0, ...printFeatures(work.outside).corners.map(({ size }) => size)];
  // At a broken corner the edge itself is inside the material: it counts as visible within the size of the break.
  const isSeen = ({ from: p }: { readonly from: Pt }) =>
    breaks.some((by) => isOutmost(body, at(p.z - by, p.r)) || isOutmost(body, at(p.z + by, p.r)));
  // An outline may run out beside the blank: a length begins at the part.
  const onBody = (p: Pt): Pt => {
    const near = breaks.flatMap((by) => [p.z - by - BESIDE, p.z + by + BESIDE]);
    const high = Math.max(...near.map((z) => spanAt(body, z)?.high ?? 0));
    return at(p.z, high > 0 ? Math.min(high, p.r) : p.r);
  };
  const zero = at(0, spanAt(body, -BESIDE)?.high ?? 0);
  return {
    body,
    bounds: box,
    form: "lines",
    view: { broken, section: isHollow(body) ? "upper" : "none", threads: work.threads },
    across: (scale) => {
      // A text longer than its diameter would cross its own lines: it becomes a note.
      const isShort = ({ r, size }: Across) => r * scale < widthOf(size) / 2 + AIR;
      const on = (side: "right" | "left") =>
        sided.flatMap(({ a, side: own }) => (own === side && !isShort(a) ? [a] : [])).sort((a, b) => a.r - b.r);
      const [right, left] = [on("right"), on("left")];
      return { right, left, noted: sizes.across.filter((each) => !right.includes(each) && !left.includes(each)) };
    },
    below: sizes.positions.filter(isSeen).map((each) => ({ ...each, from: onBody(each.from) })),
    above: sizes.positions.filter((each) => !isSeen(each)),
    zero: { below: zero, above: zero },
    notes: sizes.notes,
    list: sizes.list,
    general: sizes.general,
  };
}
