import { issue, type Issue } from "../kernel/plan/issue.ts";
import { at, type Pt } from "../kernel/geometry/point.ts";
import { type Axial, degrees, type Diameter, radius, toDiameter, toRadius } from "../kernel/units.ts";
import { type BoxOutline, PLAIN, type ShoulderValues } from "./shoulder-outline.ts";

/** What a simple cycle asks for of its box: the second corner. The first one is where the tool stands at the call. */
interface EndPoint {
  readonly Q493: Diameter;
  readonly Q494: Axial;
}

/** Nothing leans, no edge is broken, no corner is rounded. */
const SQUARE = { ...PLAIN, Q495: degrees(0) } as const;

/** The smallest box that a picture draws where no start point is known, mm. */
const LEAST = 5;

/** How long a box is drawn against its end, and how high against its length. */
const [SHARE, SLIM] = [0.5, 0.25];

/** A start point in front of an end point and outside it, where none is known yet: from Z0 where that lies in front. */
function likelyStart({ Q493, Q494 }: EndPoint): Pt {
  const end = at(Q494, Math.max(0, toRadius(Q493)));
  const size = Math.max(LEAST, end.r * SHARE);
  const front = end.z < 0 ? 0 : end.z + size;
  return at(front, end.r + Math.max(size, (front - end.z) * SLIM));
}

/** The values of the extended cycle that cuts the box from a start point to the end point of a simple one. */
export function fromStart<V extends EndPoint>(v: V, start: Pt | null): V & ShoulderValues {
  const first = start ?? likelyStart(v);
  // Beyond the axis no box begins: the plan refuses to start there.
  return { ...v, ...SQUARE, Q491: toDiameter(radius(Math.abs(first.r))), Q492: first.z };
}

/** The outline of such a box, with what is wrong told of the start point where the extended cycle has a value. */
export function toldOfStart<O extends BoxOutline>(outline: O): O {
  const told = (i: Issue): Issue => {
    if (i.code !== "startEqualsEnd") return i;
    const [axis, place] = i.data.other === "Q491" ? (["X", "start.x"] as const) : (["Z", "start.z"] as const);
    return issue("startLevelWithEnd", "error", { axis, value: i.data.value }, place);
  };
  // No angle is asked for: what a tool cannot follow is told by the direction of the wall.
  return {
    ...outline,
    issues: outline.issues.map(told),
    angleAt: (_q: string, direction: number) => Math.abs(direction),
  };
}

/** What a tool cannot follow of walls that nobody gave an angle: it lies with the tool. */
export const atTool = (issues: readonly Issue[]): Issue[] =>
  issues.map((i) => (i.code === "angleNotFollowed" ? { ...i, at: "tool" } : i));
