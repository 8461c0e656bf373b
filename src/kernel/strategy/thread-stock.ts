import { extent, type Convex } from "../reach/convex.ts";
import { toFlat, toPart, type Flat, type Frame } from "../geometry/flat.ts";
import { issue, type Issue } from "../plan/issue.ts";
import type { Ring } from "../geometry/point.ts";
import { SAME } from "../tolerance.ts";
import { toDiameter } from "../units.ts";
import { heightOn, risesAt, shareAt, type ThreadLine } from "./thread-path.ts";

/** Stretch along the thread. */
interface ThreadStretch {
  readonly from: number;
  readonly to: number;
}

/** Place and height of material above the crest. */
interface StockOverCrest {
  readonly at: Flat;
  readonly over: number;
}

type ThreadPart = "before" | "over" | "behind";

/** Lower steps between stock and crest are measuring errors, mm. */
const LEAST_STEP = 0.05;

/** The highest material above the crest, or above its extension beyond the ends; the first of equal places. */
function highestOver(
  crest: readonly Flat[],
  frame: Frame,
  stock: readonly Ring[],
  { from, to }: ThreadStretch,
): StockOverCrest | null {
  let best: StockOverCrest | null = null;
  const look = (at: Flat) => {
    const over = at.v - heightOn(crest, at.u);
    if (!best || over > best.over + SAME || (over > best.over - SAME && at.u < best.at.u)) best = { at, over };
  };
  const [low, high] = [from + SAME, to - SAME];
  for (const ring of stock) {
    const corners = ring.map((p) => toFlat(frame, p));
    corners.forEach((a, i) => {
      const b = corners[(i + 1) % corners.length] as Flat;
      const [left, right] = [Math.max(low, Math.min(a.u, b.u)), Math.min(high, Math.max(a.u, b.u))];
      if (right < left) return;
      if (Math.abs(b.u - a.u) < SAME) return look(a.v > b.v ? a : b);
      const on = (u: number): Flat => ({ u, v: a.v + ((b.v - a.v) * (u - a.u)) / (b.u - a.u) });
      for (const u of [left, right, ...crest.map((p) => p.u).filter((u) => u > left && u < right)]) look(on(u));
    });
  }
  return best;
}

/** The sections of a pass: its run-in, the thread, and its overrun. */
function stretches(
  { crest }: ThreadLine,
  { from, to }: ThreadStretch,
): (ThreadStretch & { readonly where: ThreadPart })[] {
  const [first, last] = [(crest[0] as Flat).u, (crest.at(-1) as Flat).u];
  return [
    { where: "over", from: first, to: last },
    { where: "before", from, to: first },
    { where: "behind", from: last, to },
  ];
}

const FIELD: Readonly<Record<ThreadPart, string>> = { over: "crest", before: "runIn", behind: "overrun" };

/** The finding about material above the crest; `most`: permitted height, where it is exceeded. */
function stockIssue(frame: Frame, where: ThreadPart, { at, over }: StockOverCrest, most?: number): Issue {
  const { r, z } = toPart(frame, at);
  const data = { place: where, over, x: toDiameter(r), z };
  return most === undefined
    ? issue("threadMeets", "warning", data, FIELD[where])
    : issue("threadMeets", "error", { ...data, most }, FIELD[where]);
}

/**
 * Reports material above the crest, and higher material in the run-in or the overrun: the first pass cuts it on top of
 * its infeed, and between the grooves it remains. Empty if the stock is unknown.
 */
export function stockOverCrestIssues(
  w: ThreadLine,
  frame: Frame,
  stock: readonly Ring[] | null,
  along: ThreadStretch,
): Issue[] {
  let threshold = LEAST_STEP;
  return stretches(w, along).flatMap(({ where, ...between }) => {
    const stands = highestOver(w.crest, frame, stock ?? [], between);
    if (!stands || stands.over <= threshold) return [];
    if (where === "over") threshold = stands.over + LEAST_STEP;
    return [stockIssue(frame, where, stands)];
  });
}

/**
 * In a groove deeper than the height of the insert, the walls would close behind the insert, however thin each pass is.
 * Reports material too high above the thread or above its run-in; null if there is none. Material in the overrun is a
 * visible collision in the stock; but at the bottom of a bore there is no way back.
 */
export function stockTooHighIssue(
  w: ThreadLine,
  frame: Frame,
  insert: Convex,
  stock: readonly Ring[] | null,
  { from, to }: ThreadStretch,
): Issue | null {
  const { maxV } = extent(insert);
  const rises = risesAt(w);
  const found = stretches(w, { from, to }).flatMap(({ where, ...between }) => {
    const parts =
      where === "over" && rises < between.to
        ? [
            { ...between, to: rises },
            { ...between, from: rises },
          ]
        : [between];
    return parts.flatMap((part) => {
      const stands = highestOver(w.crest, frame, stock ?? [], part);
      if (!stands || (where === "behind" && toPart(frame, stands.at).r > SAME)) return [];
      const most = maxV - w.depth * shareAt(w, stands.at.u);
      return stands.over > most + SAME ? [{ where, stands, most }] : [];
    });
  });
  const [worst] = found.sort((a, b) => b.stands.over - a.stands.over);
  return worst ? stockIssue(frame, worst.where, worst.stands, worst.most) : null;
}
