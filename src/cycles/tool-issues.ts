import { normalEnd, normalStart } from "../kernel/reach/convex.ts";
import { normalAt, segmentToFlat, type Frame } from "../kernel/geometry/flat.ts";
import { insertShape, isBar, noseRadius } from "../kernel/cutter/insert.ts";
import { inFrame } from "../kernel/reach/convex.ts";
import { positive } from "../kernel/geometry/segments.ts";
import { issue, type Issue } from "../kernel/plan/issue.ts";
import type { Plan } from "../kernel/plan/plan.ts";
import type { Segment } from "../kernel/geometry/point.ts";
import type { Tool } from "../kernel/plan/tool.ts";
import { inDegrees, type Length } from "../kernel/units.ts";
import { ROUND } from "../kernel/tolerance.ts";

/** Rounding of angles, radians. */
const ANGLE = 1e-6;

/**
 * A contour with the Q that each segment comes from, or with the places of its segments in a programmed contour, from
 * 1.
 */
interface Named {
  readonly contour: readonly Segment[];
  readonly names?: readonly string[];
  readonly elements?: readonly number[];
}

/** An angle in degrees between half a turn back (which it is not) and half a turn on. */
const halfTurns = (degrees: number) => 180 - ((((180 - degrees) % 360) + 360) % 360);

/**
 * Straight elements whose direction the nose cannot take, because a flank of the insert touches first; of one Q, or of
 * a programmed contour, the one that leans farthest beyond what it can. `asValue` turns a direction (degrees against
 * the cutting direction, positive rising) into a value of a Q.
 */
export function angleIssues(
  { contour, names, elements }: Named,
  tool: Tool,
  frame: Frame,
  asValue: (q: string, direction: number) => number,
): Issue[] {
  const shape = inFrame(insertShape(tool), frame);
  const edgeAt = (i: number) => {
    // What stays beside a bar is laid to its width as well.
    if (isBar(tool)) return "toolWidth";
    return shape[(i + shape.length) % shape.length]?.feature === "mainEdge" ? "mainEdge" : "secondaryEdge";
  };
  const normals = shape.flatMap((e, i) =>
    e.kind === "arc" && e.feature === "nose"
      ? [
          {
            from: normalStart(e) + Math.PI,
            width: normalEnd(e) - normalStart(e),
            edges: [edgeAt(i - 1), edgeAt(i + 1)] as const,
          },
        ]
      : [],
  );
  const width = shape.filter((e) => e.feature === "width").map((e) => normalStart(e) + Math.PI);
  const bounds = normals
    .flatMap((x) => [
      { at: x.from, edge: x.edges[0] },
      { at: x.from + x.width, edge: x.edges[1] },
    ])
    .map((b) => ({
      at: halfTurns(inDegrees(b.at) - 90),
      edge: b.edge,
    }));
  const reached = (a: number) =>
    normals.some((n) => positive(a - n.from + ANGLE) <= n.width + 2 * ANGLE) ||
    width.some((w) => Math.abs(Math.sin((a - w) / 2)) < ANGLE);
  const found = new Map<string, { readonly issue: Issue; readonly beyond: number }>();
  contour.forEach((segment, i) => {
    if (segment.kind !== "line") return;
    const n = normalAt(segmentToFlat(frame, segment), "from");
    const a = Math.atan2(n.v, n.u);
    if (reached(a)) return;
    const name = names?.[i] ?? "contour";
    const direction = halfTurns(inDegrees(a) - 90);
    const { at: max, edge } = bounds.reduce(
      (best, b) => (Math.abs(b.at - direction) < Math.abs(best.at - direction) ? b : best),
      bounds[0] ?? { at: 0, edge: "mainEdge" },
    );
    const beyond = Math.abs(max - direction);
    if (beyond <= (found.get(name)?.beyond ?? 0)) return;
    const data = {
      angle: asValue(name, direction),
      max: asValue(name, max),
      edge,
      ...(elements && { element: elements[i] ?? 0 }),
    };
    found.set(name, { issue: issue("angleNotFollowed", "warning", data, name), beyond });
  });
  return [...found.values()].map((f) => f.issue);
}

/** A programmed corner radius that the insert is too round for. */
export function cornerIssue(corner: Length, tool: Tool): Issue[] {
  const insert = noseRadius(tool);
  return corner > 0 && corner < insert - ROUND
    ? [issue("cornerSmallerThanInsert", "warning", { radius: corner, insert }, "Q500")]
    : [];
}

/** A plan with what its tool cannot follow; a tool that is unfit altogether needs no details. */
export const withIssues = (plan: Plan, found: readonly Issue[]): Plan =>
  plan.issues.some((i) => i.code === "toolUnfit") ? plan : { ...plan, issues: [...plan.issues, ...found] };
