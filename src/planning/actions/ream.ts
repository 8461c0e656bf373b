import { boxAround } from "../../kernel/area/box.ts";
import { at, part as geometry, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { CHORD, SAME, SLIVER } from "../../kernel/tolerance.ts";
import { radius, rounded, toDiameter } from "../../kernel/units.ts";
import { frontOf } from "../../program/job/stock-surface.ts";
import { canDo } from "../../program/edits/hand-operation.ts";
import { reamerHole, reams } from "../../program/tools/reamed-hole.ts";
import type { Action, ActionSource, PlannedPart, PlanRequest } from "../types.ts";
import { clearRadius, insideOf } from "./bore.ts";
import { drillsOf, onAxis } from "./on-axis.ts";
import { valuesOf } from "./values-of-job.ts";

/** Stock in front of the face that is no reason to face first, mm. */
const FACED = 0.05;
/** The chamfer that cuts: it passes the end of a reamed cylinder, mm (recalled, tag K). */
const LEAD = 1;

/** Reamers of the table. */
export const reamersOf = (request: PlanRequest): readonly Tool[] =>
  drillsOf(request).filter((tool) => canDo("ream", tool, { isInside: true, depth: 0 }));

/** The cylinders of a bore that a reamer makes, and the Z of its front edge behind them. */
interface Reamed {
  readonly cylinders: readonly Segment[];
  readonly rear: number;
}

/**
 * What a reamer makes in a part: it comes from the front, where nothing is narrower, and passes behind the last cylinder.
 * Null where it makes none, or not to its end.
 */
export function reamedBy(reamer: Tool, { inside: { segments, marks } }: PlannedPart): Reamed | null {
  const r = (reamer.R ?? 0) - 2 * SLIVER;
  const cylinders = segments.filter(({ from, to }, i) => {
    const { tolerance, roughness } = marks[i] ?? {};
    const wanted = { diameter: toDiameter(radius(from.r)), tolerance, roughness };
    return Math.abs(from.r - to.r) < SAME && reams(reamer, wanted);
  });
  const last = cylinders.at(-1);
  if (!last) return null;
  const rear = last.to.z - LEAD;
  const isFree = geometry.flattenedChain(segments, CHORD).every((to, i, all) => {
    const from = all[i - 1] ?? to;
    // Of what ends behind its edge, as the cone that a drill leaves, the place at the edge counts.
    const share = to.z < rear && from.z > rear ? (from.z - rear) / (from.z - to.z) : 1;
    return (to.z < rear + SAME && share === 1) || from.r + share * (to.r - from.r) > r;
  });
  return isFree ? { cylinders, rear } : null;
}

/** Whether the flutes of a reamer are as long as the bore is deep: chips leave through them. */
export const reachesRear = (tool: Tool, { rear }: Reamed, stock: readonly Ring[]): boolean =>
  frontOf(stock) - rear <= (tool.CUTLENGTH ?? Infinity);

/** The cylinders that a reamer makes from a hole that is there; null where it cannot. */
function reamable(tool: Tool, stock: readonly Ring[], { part }: PlanRequest): Reamed | null {
  const made = reamedBy(tool, part);
  const front = frontOf(stock);
  const { least, most } = reamerHole(tool);
  // It follows a hole, and widens it by no more than its edges take.
  const isOpen = made?.cylinders.some(({ from, to }) => clearRadius(stock, to.z, from.z) <= most + SAME) ?? false;
  if (!made || !isOpen || !reachesRear(tool, made, stock)) return null;
  return clearRadius(stock, made.rear, front) < least - SAME ? null : made;
}

/** Least time of reaming, down and back, s. */
export function reamSeconds(tool: Tool, { rear }: Reamed, stock: readonly Ring[], request: PlanRequest): number {
  const depth = frontOf(stock) - rear;
  const cut = { operation: "both", work: "ream", smallest: 0, largest: 0, stock, depth } as const;
  const { feed, speed } = valuesOf(tool, cut, request);
  return (2 * 60 * depth) / (feed.value * speed.value);
}

/** What reamers take of the holes that are there: it is too thin for a bar, whose nose would rub. */
export const reamedSkin = (stock: readonly Ring[], request: PlanRequest): readonly Ring[] =>
  reamersOf(request).flatMap((tool) =>
    (reamable(tool, stock, request)?.cylinders ?? []).map(({ from, to }) => {
      const high = from.r + 2 * SLIVER;
      return [at(to.z, 0), at(from.z, 0), at(from.z, high), at(to.z, high)];
    }),
  );

function reamAction(tool: Tool, stock: readonly Ring[], request: PlanRequest): Action | null {
  const made = reamable(tool, stock, request);
  if (!made) return null;
  const { rear } = made;
  const front = frontOf(stock);
  const cut = onAxis("ream", tool, rounded(front - rear), stock, request);
  return (
    cut && {
      ...cut,
      kind: "ream",
      key: `ream T${tool.T} Z${rounded(rear)}`,
      site: "inside",
      tool,
      place: { front, rear, high: tool.R ?? 0, low: reamerHole(tool).least },
      threads: [],
    }
  );
}

/** Reams cylinders of a bore behind the drill of their undersize. */
export const ream: ActionSource = {
  kind: "ream",
  actions({ stock }, request) {
    const inside = insideOf(request.part);
    if (!inside || frontOf(stock) > boxAround([inside]).right + FACED) return [];
    return reamersOf(request).flatMap((tool) => reamAction(tool, stock, request) ?? []);
  },
};
