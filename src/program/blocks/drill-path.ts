import { holeOf } from "../../kernel/cutter/drill.ts";
import type { NeededHole } from "../../kernel/time/step.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { length } from "../../kernel/units.ts";

/**
 * Moves of the drilling cycles, mm. Parameter lists and order of moves are recalled (decision "Drilling on the axis"),
 * not verified on a printed page.
 */
export interface DrillMove {
  /** Z of the drill point. */
  readonly to: number;
  /** null: rapid. */
  readonly feed: DrillFeed | null;
  /** Dwell at the end, s. */
  readonly dwell?: number;
}

/** A feed by its parameter, or the thread pitch per revolution. */
export type DrillFeed = { readonly q: "Q206" | "Q208" | "Q253" } | { readonly pitch: number };

/** Numbers of the definition by their Q; lengths mm. */
export type Q = (name: string) => number;

/** Surface and bottom of a bore, and the set-up clearance above. */
export interface Bore {
  readonly surface: number;
  readonly bottom: number;
  readonly clear: number;
  readonly away: number;
}

/** Most infeeds of one bore; more are surely a typing error. */
const MOST_PECKS = 2000;

/** Depth of each infeed under the surface, the last one the full depth; null when there are too many. */
function pecks(whole: number, first: number, less: number, least: number): number[] | null {
  const out: number[] = [];
  let [depth, infeed] = [0, first > 0 ? first : whole];
  // A sum of decimals may fall short of the depth by its rounding: that is no further infeed.
  while (depth + infeed < whole - SAME) {
    depth += infeed;
    out.push(depth);
    if (out.length >= MOST_PECKS) return null;
    const next = Math.max(infeed - less, Math.min(least, infeed));
    if (next > 0) infeed = next;
  }
  return [...out, whole];
}

const DOWN: DrillFeed = { q: "Q206" };
const BACK: DrillFeed = { q: "Q208" };

/** Moves of a cycle from its set-up clearance; null when its values make no bore. */
export function drillPath(cycle: number, q: Q, bore: Bore): DrillMove[] | null {
  const made = MOVES[cycle]?.(q, bore) ?? null;
  if (!made) return null;
  return [{ to: bore.clear, feed: null }, ...made, ...(bore.away > bore.clear ? [{ to: bore.away, feed: null }] : [])];
}

function downAndBack(q: Q, { bottom, clear }: Bore): DrillMove[] {
  return [
    { to: bottom, feed: DOWN, dwell: q("Q211") },
    { to: clear, feed: BACK },
  ];
}

/**
 * Cycles that widen a hole, and the most they remove, as a share of the tool radius and in mm: a reamer removes little.
 */
const WIDENS: ReadonlyMap<number, { readonly share: number; readonly most: number }> = new Map([
  [201, { share: 0.5, most: 0.5 }],
  [
    202,
    {
      share: 0.5,
      most: Infinity,
    },
  ],
]);

/** Hole required before a cycle; null where the cycle makes it. */
export function holeBefore(cycle: number, tool: Tool, q: Q): NeededHole | null {
  if (q("Q239") !== 0) return holeOf(tool, Math.abs(q("Q239")));
  const widened = WIDENS.get(cycle);
  const r = tool.R ?? 0;
  if (!widened) return null;
  const radius = length(Math.max(r * (1 - widened.share), r - widened.most));
  return { radius, drill: radius };
}

const MOVES: Readonly<Record<number, (q: Q, bore: Bore) => DrillMove[] | null>> = {
  200: (q, bore) =>
    pecking(q, bore, { infeeds: [q("Q202"), 0, 0], back: null, rest: q("Q210"), ahead: () => q("Q200") }),
  201: downAndBack,
  // The step off the wall at the bottom (Q214, Q336) is within the bore.
  202: downAndBack,
  203: (q, bore) =>
    pecking(q, bore, {
      infeeds: [q("Q202"), q("Q212"), q("Q205")],
      back: BACK,
      rest: q("Q210"),
      ahead: () => q("Q200"),
      breaks: { count: q("Q213"), by: q("Q256") },
    }),
  205: deep,
  206: (q, { bottom, clear }) => [
    { to: bottom, feed: DOWN, dwell: q("Q211") },
    { to: clear, feed: DOWN },
  ],
  207: (q, { bottom, clear }) => {
    const feed = { pitch: Math.abs(q("Q239")) };
    return feed.pitch > 0
      ? [
          { to: bottom, feed },
          { to: clear, feed },
        ]
      : null;
  },
  209: chipBreakingTap,
  240: (q, { bottom, clear }) => [
    { to: bottom, feed: DOWN, dwell: q("Q211") },
    { to: clear, feed: null },
  ],
};

interface Pecking {
  /** First infeed, decrement per infeed, and smallest infeed. */
  readonly infeeds: readonly [first: number, less: number, least: number];
  /** Retraction feed; null: rapid. */
  readonly back: DrillFeed | null;
  /** Dwell outside between two infeeds, s. */
  readonly rest: number;
  /** Distance above the last depth at which the rapid down ends. */
  readonly ahead: (depth: number, whole: number) => number;
  /** Chip breaks inside the bore before the tool retracts. */
  readonly breaks?: { readonly count: number; readonly by: number };
}

/** Infeed by infeed, retracting out of the bore or by a little to break the chip. */
function pecking(q: Q, { surface, bottom, clear }: Bore, p: Pecking): DrillMove[] | null {
  const whole = surface - bottom;
  const depths = pecks(whole, ...p.infeeds);
  if (!depths) return null;
  let broken = 0;
  return depths.flatMap((depth, i): DrillMove[] => {
    const last = i === depths.length - 1;
    const at = last ? bottom : surface - depth;
    const down: DrillMove = { to: at, feed: DOWN, ...(last && { dwell: q("Q211") }) };
    if (last) return [down, { to: clear, feed: p.back }];
    if (p.breaks && p.breaks.by > 0 && broken < p.breaks.count) {
      broken += 1;
      return [down, { to: Math.min(clear, at + p.breaks.by), feed: null }];
    }
    broken = 0;
    const again = Math.min(clear, at + p.ahead(depth, whole));
    return [down, { to: clear, feed: p.back, dwell: p.rest }, { to: again, feed: null }];
  });
}

/** 205: deepened start point, chip breaking, and an advanced stop distance that grows with the depth. */
function deep(q: Q, bore: Bore): DrillMove[] | null {
  const below = Math.abs(q("Q379"));
  const start = bore.surface - below;
  const [near, far] = [q("Q258"), q("Q259")];
  const inner: Bore = { ...bore, surface: start };
  if (start <= bore.bottom) return null;
  const made = pecking(q, inner, {
    infeeds: [q("Q202"), q("Q212"), q("Q205")],
    back: null,
    rest: 0,
    ahead: (depth, whole) => near + ((far - near) * depth) / whole,
  });
  const broken = made && chipsBroken(made, { every: q("Q257"), by: q("Q256"), from: start });
  if (!broken) return null;
  const way: DrillMove[] = below > 0 ? [{ to: Math.min(bore.clear, start + q("Q200")), feed: { q: "Q253" } }] : [];
  return [...way, ...broken.slice(0, -1), { to: bore.clear, feed: BACK }];
}

/** Divides every cut at its chip breaks. */
function chipsBroken(
  moves: readonly DrillMove[],
  { every, by, from }: { readonly every: number; readonly by: number; readonly from: number },
): DrillMove[] | null {
  if (!(every > 0) || !(by > 0)) return [...moves];
  const out: DrillMove[] = [];
  let deepest = from;
  for (const m of moves) {
    if (m.feed && m.to < deepest) {
      const steps = Math.ceil((deepest - m.to - SAME) / every) - 1;
      if (!(out.length + steps < 2 * MOST_PECKS)) return null;
      for (let i = 1; i <= steps; i += 1) {
        const at = deepest - i * every;
        out.push({ to: at, feed: m.feed }, { to: at + by, feed: null });
      }
      deepest = m.to;
    }
    out.push(m);
  }
  return out;
}

/** 209: tapping with chip breaking, retracting by some pitches or completely. */
function chipBreakingTap(q: Q, { surface, bottom, clear }: Bore): DrillMove[] | null {
  const feed = { pitch: Math.abs(q("Q239")) };
  const depths = pecks(surface - bottom, q("Q257"), 0, 0);
  if (!depths || !(feed.pitch > 0)) return null;
  const by = q("Q256") * feed.pitch;
  return depths.flatMap((depth, i) => {
    const at = i === depths.length - 1 ? bottom : surface - depth;
    const back = i === depths.length - 1 || !(by > 0) ? clear : Math.min(clear, at + by);
    return [
      { to: at, feed },
      { to: back, feed },
    ];
  });
}
