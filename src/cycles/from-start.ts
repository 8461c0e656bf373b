import { issue, type Issue } from "../kernel/plan/issue.ts";
import { at, type Pt } from "../kernel/geometry/point.ts";
import { type Axial, degrees, type Diameter, radius, toDiameter, toRadius } from "../kernel/units.ts";
import { type BoxOutline, PLAIN, type ShoulderValues } from "./shoulder-outline.ts";

/** The box of a simple cycle: its second corner. The first corner is the tip at the call. */
interface EndPoint {
  readonly Q493: Diameter;
  readonly Q494: Axial;
}

/** Square walls, sharp edges and sharp corners. */
const SQUARE = { ...PLAIN, Q495: degrees(0) } as const;

/** The smallest box that a picture shows while the start point is unknown, mm. */
const LEAST = 5;

/** Length of such a box as a share of its end radius, and its height as a share of its length. */
const [SHARE, SLIM] = [0.5, 0.25];

/** An assumed start point in front of an end point and outside it: at Z0 where that is in front. */
function likelyStart({ Q493, Q494 }: EndPoint): Pt {
  const end = at(Q494, Math.max(0, toRadius(Q493)));
  const size = Math.max(LEAST, end.r * SHARE);
  const front = end.z < 0 ? 0 : end.z + size;
  return at(front, end.r + Math.max(size, (front - end.z) * SLIM));
}

/** The values of the extended cycle that cuts the box from a start point to the end point of a simple cycle. */
export function extendedValues<V extends EndPoint>(v: V, start: Pt | null): V & ShoulderValues {
  const first = start ?? likelyStart(v);
  // No box begins beyond the axis: the plan refuses to start there.
  return { ...v, ...SQUARE, Q491: toDiameter(radius(Math.abs(first.r))), Q492: first.z };
}

/** The outline of such a box, with issues reported at the start point where the extended cycle has a value. */
export function withStartPointIssues<O extends BoxOutline>(outline: O): O {
  const told = (i: Issue): Issue => {
    if (i.code !== "startEqualsEnd") return i;
    const [axis, place] = i.data.other === "Q491" ? (["X", "start.x"] as const) : (["Z", "start.z"] as const);
    return issue("startLevelWithEnd", "error", { axis, value: i.data.value }, place);
  };
  // The cycle has no angle value: report the direction of the wall that the tool cannot follow.
  return {
    ...outline,
    issues: outline.issues.map(told),
    angleAt: (_q: string, direction: number) => Math.abs(direction),
  };
}

/** Reports angle issues at the tool: the walls of a simple cycle have no angle value. */
export const angleIssuesAtTool = (issues: readonly Issue[]): Issue[] =>
  issues.map((i) => (i.code === "angleNotFollowed" ? { ...i, at: "tool" } : i));
