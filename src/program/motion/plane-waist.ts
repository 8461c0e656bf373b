import { issue } from "../../kernel/plan/issue.ts";
import { largestThatWorks, withOffer } from "../../kernel/plan/offer.ts";
import { LEAST_PATH_CUT, pathCut } from "../../kernel/plane/path-check.ts";
import { planeContour, type PlaneContour } from "../../kernel/plane/plane-contour.ts";
import { SAME } from "../../kernel/tolerance.ts";
import type { Carrier } from "./carrier.ts";
import type { ChainItem, CompensatedChain } from "../state/plane-chain.ts";

/** Longest contour in which a smaller radius is searched: every try compensates all elements. */
const MOST_TRIED = 60;

/** Whether the tool is below the top of the part along an element, or on the corner after it. */
function isBelow(item: ChainItem | undefined, onCorner: boolean, top: number | null): boolean {
  if (!item || top === null) return true;
  const heights = onCorner ? [item.lifts.at(-1)?.toZ ?? item.toZ] : [item.fromZ, item.toZ];
  return heights.some((z) => z === null || z < top);
}

/** Deepest cut of the path into its own contour. A path that does not fit its neighbours is reported before. */
function cutOf(contour: PlaneContour, { items }: CompensatedChain, { top }: Carrier, toolRadius: number) {
  const indices = new Map<string, number>();
  const key = (element: number, onCorner: boolean) => `${element} ${onCorner}`;
  contour.contour.forEach((c, i) => indices.set(key(c.element, c.onCorner), i));
  const milled = contour.path.filter((p) => isBelow(items[p.element], p.onCorner || p.part === "corner", top));
  const pieces = milled.map((p) => ({ segment: p.segment, element: indices.get(key(p.element, p.onCorner)) ?? 0 }));
  const isWall = (i: number) => {
    const c = contour.contour[i];
    return c !== undefined && isBelow(items[c.element], c.onCorner, top);
  };
  const cut = pathCut(
    contour.contour.map((c) => c.segment),
    pieces,
    toolRadius,
    isWall,
  );
  return cut && { ...cut, by: milled[cut.piece], wall: contour.contour[cut.into] };
}

/**
 * Reports path cuts that a control misses: it compares neighbouring elements only and mills through a waist narrower
 * than its tool.
 */
export function sayPathCut(carrier: Carrier, chain: CompensatedChain, contour: PlaneContour): void {
  // A turning tool is no full circle, and its cuts are verified elsewhere.
  if (carrier.plane !== "XY" || chain.side === "none" || contour.issues.some((each) => each.issue.severity === "error"))
    return;
  const cut = cutOf(contour, chain, carrier, carrier.toolRadius);
  if (!cut?.by || !cut.wall) return;
  const { by, wall, depth, on } = cut,
    item = chain.items[by.element];
  if (!item) return;
  const found = issue(
    "pathCutsContour",
    "warning",
    { element: by.element + 1, other: wall.element + 1, depth, x: on.x, y: on.y },
    "tool",
  );
  const fits = (size: number) => {
    const smaller = planeContour(
      chain.items.map(({ segment, corner }) => ({ segment, ...(corner && { corner: corner.element }) })),
      chain.side,
      size,
    );
    // The offered radius must pass without any cut.
    return smaller.issues.length === 0 && cutOf(smaller, chain, carrier, size + LEAST_PATH_CUT - SAME) === null;
  };
  const nearest = chain.items.length <= MOST_TRIED ? largestThatWorks(carrier.toolRadius, fits) : null;
  carrier.machine.log.report(withOffer(found, nearest), by.onCorner ? (item.corner?.index ?? item.index) : item.index);
}
