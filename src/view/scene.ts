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

/** Content of the static part of the picture. */
export interface SceneParts {
  readonly blank: readonly Ring[];
  /** The clamping; null or absent if not stated. */
  readonly clamping?: Clamped | null;
  readonly contours: readonly (readonly Segment[])[];
  readonly steps: readonly Step[];
  /** Lines of the path, if already made. */
  readonly path?: readonly Shape[];
  /** Boxes of the tip positions, if already known. */
  readonly ways?: readonly TipWays[];
  /** The known part of a contour that is not complete yet. */
  readonly sketch?: readonly Segment[];
  /** Further points that must be visible. */
  readonly framedPoints?: readonly Pt[];
  /** The box round all contacts of the tool with the clamping, which must be drawn there. */
  readonly contacts?: Bounds | null;
  /** Position of a tool before there is a path, and the tool. */
  readonly parkedTool?: { readonly at: Pt; readonly tool: Tool | null } | null;
}

/** The static part of the picture, from back to front, and the box that contains all of it. */
export interface Scene {
  readonly shapes: readonly Shape[];
  readonly chuck: ChuckDrawing | null;
  readonly bounds: Bounds;
}

/** The form of a move: plunging takes precedence over the phase; positioning feeds look like feeds. */
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

/** Chord tolerance of inserts when only their size counts, mm. */
const COARSE = 0.2;

/** The box round an insert whose tip moves through a box, at most `most` mm from the tip to each side. */
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

/** The box of a tool's tip positions in some moves, all of cycles or all of path blocks. */
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

/** The boxes of all tip positions in some steps. */
export function tipWays(steps: readonly Step[]): readonly TipWays[] {
  const own = new Map<Tool, TipWays>(),
    between = new Map<Tool, TipWays>();
  for (const { from, move, tool, operation } of steps) {
    const boxes = operation === null ? between : own;
    boxes.set(tool, grown(boxes.get(tool), tool, operation !== null, from, move.to));
  }
  return [...own.values(), ...between.values()];
}

/** The box round every position of every insert. */
export const workingBox = (ways: readonly TipWays[], most = Infinity): Bounds | null =>
  ways.reduce<Bounds | null>(
    (all, way) => (way.left <= way.right && way.low <= way.high ? joined(all, insertBox(way, way.tool, most)) : all),
    null,
  );

/** Fallback for an empty picture: 100 mm of axis. */
const EMPTY: Bounds = { left: -80, right: 20, low: 0, high: 40 };

/** Margin, mm per mm of size. */
const AIR = 0.02;

/** The picture frames the cycles, so that positioning from far away (a tool change) does not shrink the work. */
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
  framedPoints = [],
  parkedTool = null,
  contacts = null,
}: SceneParts): Scene {
  const material = boundsOf(blank.flat());
  const all = ways ?? tipWays(steps),
    low = all.reduce((least, way) => Math.min(least, way.low), 0);
  const outline = boundsOf([...contours, sketch].flatMap((c) => [...pointsOf(c)]).concat(framedPoints));
  const chuck = material ? chuckDrawing(blank, material, clamping, contacts) : null;
  const shapes: Shape[] = [];
  if (blank.length > 0) shapes.push({ role: "blank", d: ringData(blank) });
  if (sketch.length > 0) shapes.push({ role: "sketch", d: segmentData(sketch) });
  shapes.push(...contourShapes(contours), ...(drawn ?? toolpath(steps)));
  // On a tiny part an insert would fill most of the picture.
  const most = material ? material.high : Infinity;
  const tip = boundsOf(parkedTool ? [parkedTool.at] : []),
    standing = tip && parkedTool?.tool ? insertBox(tip, parkedTool.tool, most) : tip;
  const seen =
    joined(joined(material, joined(joined(workingBox(framed(all), most), standing), outline)), chuck?.seen ?? null) ??
    EMPTY;
  // The other half of work and clamping is below the axis.
  const axis = { ...seen, low: Math.min(low, -Math.max(material?.high ?? 0, chuck?.seen.high ?? 0)) };
  return { shapes, chuck, bounds: grownBounds(axis, AIR * Math.max(axis.right - axis.left, axis.high - axis.low)) };
}
