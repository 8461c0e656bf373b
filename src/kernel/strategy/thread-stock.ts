import { extent, type Convex } from "../convex.ts";
import { toFlat, toPart, type Flat, type Frame } from "../flat.ts";
import { issue, type Issue } from "../issue.ts";
import type { Ring } from "../point.ts";
import { SAME } from "../tolerance.ts";
import { toDiameter } from "../units.ts";
import type { Frontier } from "./frontier.ts";
import { heightOn, shareAt, type ThreadLine } from "./thread-path.ts";

/** Stretch along the thread. */
interface Between {
  readonly from: number;
  readonly to: number;
}

/** Where material stands over the crest, and how high. */
interface Stands {
  readonly at: Flat;
  readonly over: number;
}

type Where = "before" | "over" | "behind";

/** Lower steps between stock and crest are measuring, not material, mm. */
const TOLD = 0.05;

/** Where material stands highest over the crest, or over the line of it beyond its ends; of equal places the first. */
function highestOver(crest: readonly Flat[], frame: Frame, stock: readonly Ring[], { from, to }: Between): Stands | null {
  let best: Stands | null = null;
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

/** The stretches of the way of a pass: its run-in, the thread, and its overrun. */
function stretches({ crest }: ThreadLine, { from, to }: Between): (Between & { readonly where: Where })[] {
  const [first, last] = [(crest[0] as Flat).u, (crest.at(-1) as Flat).u];
  return [{ where: "over", from: first, to: last }, { where: "before", from, to: first }, { where: "behind", from: last, to }];
}

const FIELD: Readonly<Record<Where, string>> = { over: "crest", before: "runIn", behind: "overrun" };

/** The finding about what stands there; `most`: how high it may stand, where it stands higher. */
function meets(frame: Frame, where: Where, { at, over }: Stands, most?: number): Issue {
  const { r, z } = toPart(frame, at);
  const data = { place: where, over, x: toDiameter(r), z };
  return most === undefined
    ? issue("threadMeets", "warning", data, FIELD[where])
    : issue("threadMeets", "error", { ...data, most }, FIELD[where]);
}

/**
 * What stands over the crest, and what is higher than that in the run-in or the overrun: the first pass takes it on top of its infeed,
 * and between the grooves it stays. Nothing where nobody knows the stock.
 */
export function standingOver(w: ThreadLine, frame: Frame, stock: readonly Ring[] | null, along: Between): Issue[] {
  let told = TOLD;
  return stretches(w, along).flatMap(({ where, ...between }) => {
    const stands = highestOver(w.crest, frame, stock ?? [], between);
    if (!stands || stands.over <= told) return [];
    if (where === "over") told = stands.over + TOLD;
    return [meets(frame, where, stands)];
  });
}

/** Places along a thread at which it is looked at how high material stands over it, and how near they are at the nearest, mm. */
const PLACES = { most: 400, nearest: 0.5 } as const;

/**
 * Over a groove deeper than the insert is high its own walls would close behind the insert, however thin each pass is: what stands
 * too high over the thread, or is in the way before or behind it; null where nothing does.
 */
export function tooHigh(
  w: ThreadLine,
  { frame, insert, frontier, stock, ...along }: Between & { readonly frame: Frame; readonly insert: Convex; readonly frontier: Frontier;
    readonly stock: readonly Ring[] | null },
): Issue | null {
  const { minU, maxU, maxV } = extent(insert);
  const each = Math.max(PLACES.nearest, (along.to - along.from) / PLACES.most);
  const depthAt = (u: number) => w.depth * shareAt(w, u);
  let high = 0;
  for (let u = along.from; u < along.to; u += each)
    high = Math.max(high, depthAt(u) + frontier.over(u, u + each) - Math.min(heightOn(w.crest, u), heightOn(w.crest, u + each)));
  if (high <= maxV + SAME) return null;
  const seen = stretches(w, { from: along.from + minU, to: along.to + maxU }).flatMap(({ where, ...between }) => {
    const stands = highestOver(w.crest, frame, stock ?? [], between);
    return stands ? [{ where, stands }] : [];
  }).reduce<{ where: Where; stands: Stands } | null>((best, s) => (best && best.stands.over >= s.stands.over - SAME ? best : s), null);
  const most = seen ? maxV - depthAt(seen.stands.at.u) : 0;
  if (!seen || seen.stands.over <= most) return issue("threadOverInsert", "error", { depth: high, most: maxV }, "tool");
  return meets(frame, seen.where, seen.stands, most);
}
