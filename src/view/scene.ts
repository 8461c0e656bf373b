import type { Clamped } from "../kernel/area/clamping.ts";
import { insertOutline } from "../kernel/cutter/insert.ts";
import type { Move } from "../kernel/plan/move.ts";
import type { Pt, Ring, Segment } from "../kernel/geometry/point.ts";
import type { Step } from "../kernel/time/step.ts";
import type { Tool } from "../kernel/plan/tool.ts";
import { boundsOf, grownBounds, joined, pointsOf } from "./bounds.ts";
import type { Bounds } from "./camera.ts";
import { chuckDrawing, type ChuckDrawing } from "./material/chuck.ts";
import { moveData, ringData, segmentData, startData } from "./path.ts";

/** What a line of the toolpath is for, which decides its form. */
export const PATH_ROLES = ["rapid", "feed", "plunge", "smooth", "finish", "thread"] as const;
export type PathRole = (typeof PATH_ROLES)[number];

/** What a shape stands for. Its form and colour belong to whoever paints it. */
export type Role = PathRole | "blank" | "sketch" | "contour" | "stock" | "residual" | "gouge";

/** One shape of the display list: path data in part space (x = z, y = r, mm). */
export interface Shape {
  readonly role: Role;
  readonly d: string;
}

/** What the still part of the picture is made of. */
export interface SceneParts {
  readonly blank: readonly Ring[];
  /** What holds it; null or absent where that is not stated. */
  readonly clamping?: Clamped | null;
  readonly contours: readonly (readonly Segment[])[];
  readonly steps: readonly Step[];
  /** The lines of their path where they are made already. */
  readonly path?: readonly Shape[];
  /** Where their tips go, where that is known already. */
  readonly ways?: readonly TipWays[];
  /** A contour as far as it is known, where it is not whole yet. */
  readonly sketch?: readonly Segment[];
  /** Points beside all that which are to be seen as well. */
  readonly near?: readonly Pt[];
  /** Where a tool stands before there is a path, and which. */
  readonly waits?: { readonly at: Pt; readonly tool: Tool | null } | null;
}

/** The still part of the picture, from back to front, and the box that shows all of it. */
export interface Scene {
  readonly shapes: readonly Shape[];
  readonly chuck: ChuckDrawing | null;
  readonly bounds: Bounds;
}

/** The form of a move: plunging is told first, then the phase; positioning feeds look like feeds. */
export function pathRole(move: Move): PathRole {
  if (move.kind === "rapid") return "rapid";
  if (move.kind === "thread") return "thread";
  if (move.plunging) return "plunge";
  if (move.phase === "finish" || move.phase === "smooth" || move.phase === "thread") return move.phase;
  return "feed";
}

/** The whole toolpath as one path per form, so that thousands of moves are six elements. */
export function toolpath(steps: readonly Step[]): readonly Shape[] {
  const data = new Map<PathRole, string[]>();
  let before: PathRole | null = null,
    last: Pt | null = null;
  for (const { from, move } of steps) {
    const role = pathRole(move);
    const list = data.get(role) ?? [];
    data.set(role, list);
    const joins = role === before && last !== null && last.z === from.z && last.r === from.r;
    list.push(joins ? moveData(from, move) : startData(from) + moveData(from, move));
    before = role;
    last = move.to;
  }
  return PATH_ROLES.flatMap((role) => {
    const list = data.get(role);
    return list ? [{ role, d: list.join("") }] : [];
  });
}

/** Inserts are drawn with chords this fine when only their size counts, mm. */
const COARSE = 0.2;

/** The box round an insert whose tip goes through a box; no more of it than `most` mm from the tip to each side. */
function insertBox(way: Bounds, tool: Tool, most = Infinity): Bounds {
  const insert = boundsOf(insertOutline(tool, COARSE)),
    within = (by: number) => Math.max(-most, Math.min(most, by));
  return insert
    ? {
        left: way.left + within(insert.left),
        right: way.right + within(insert.right),
        low: way.low + within(insert.low),
        high: way.high + within(insert.high),
      }
    : way;
}

/** Where the tip of a tool goes in some moves, all of cycles or all of path blocks. */
export interface TipWays extends Bounds {
  readonly tool: Tool;
  readonly inCycle: boolean;
}

const grown = (box: TipWays | undefined, tool: Tool, inCycle: boolean, from: Pt, to: Pt): TipWays => ({
  tool,
  inCycle,
  left: Math.min(box?.left ?? from.z, from.z, to.z),
  right: Math.max(box?.right ?? from.z, from.z, to.z),
  low: Math.min(box?.low ?? from.r, from.r, to.r),
  high: Math.max(box?.high ?? from.r, from.r, to.r),
});

/** The boxes of all tips of some steps. */
export function tipWays(steps: readonly Step[]): readonly TipWays[] {
  const own = new Map<Tool, TipWays>(),
    between = new Map<Tool, TipWays>();
  for (const { from, move, tool, operation } of steps) {
    const boxes = operation === null ? between : own;
    boxes.set(tool, grown(boxes.get(tool), tool, operation !== null, from, move.to));
  }
  return [...own.values(), ...between.values()];
}

/** The box round every place of every insert. */
export const workingBox = (ways: readonly TipWays[], most = Infinity): Bounds | null =>
  ways.reduce<Bounds | null>(
    (all, way) => (way.left <= way.right && way.low <= way.high ? joined(all, insertBox(way, way.tool, most)) : all),
    null,
  );

/** A picture of nothing still has a place: 100 mm of axis. */
const EMPTY: Bounds = { left: -80, right: 20, low: 0, high: 40 };

/** Space left round everything, mm per mm of its size. */
const AIR = 0.02;

/** The picture frames the cycles; positioning from far away (a tool change) does not make the work small. */
function framed(ways: readonly TipWays[]): readonly TipWays[] {
  const cutting = ways.filter(({ inCycle }) => inCycle);
  return cutting.length > 0 ? cutting : ways;
}

/** The finished contours of a run. */
export const contourShapes = (contours: SceneParts["contours"]): readonly Shape[] =>
  contours.map((contour) => ({ role: "contour", d: segmentData(contour) }));

/** Builds the still part of the picture. */
export function sceneOf({
  blank,
  clamping = null,
  contours,
  steps,
  path: drawn,
  ways,
  sketch = [],
  near = [],
  waits = null,
}: SceneParts): Scene {
  const material = boundsOf(blank.flat());
  const all = ways ?? tipWays(steps),
    low = all.reduce((least, way) => Math.min(least, way.low), 0);
  const outline = boundsOf([...contours, sketch].flatMap((c) => [...pointsOf(c)]).concat(near));
  const chuck = material ? chuckDrawing(blank, material, clamping) : null;
  const shapes: Shape[] = [];
  if (blank.length > 0) shapes.push({ role: "blank", d: ringData(blank) });
  if (sketch.length > 0) shapes.push({ role: "sketch", d: segmentData(sketch) });
  shapes.push(...contourShapes(contours), ...(drawn ?? toolpath(steps)));
  // Beside a tiny part an insert would be most of the picture.
  const most = material ? material.high : Infinity;
  const tip = boundsOf(waits ? [waits.at] : []),
    standing = tip && waits?.tool ? insertBox(tip, waits.tool, most) : tip;
  const seen =
    joined(joined(material, joined(joined(workingBox(framed(all), most), standing), outline)), chuck?.seen ?? null) ??
    EMPTY;
  // Below the axis there is the other half of the work.
  const axis = { ...seen, low: Math.min(low, -(material?.high ?? 0)) };
  return { shapes, chuck, bounds: grownBounds(axis, AIR * Math.max(axis.right - axis.left, axis.high - axis.low)) };
}
