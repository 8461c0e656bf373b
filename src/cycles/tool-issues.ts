import { normalEnd, normalStart } from "../kernel/convex.ts";
import { normalAt, segmentToFlat, type Frame } from "../kernel/flat.ts";
import { insertShape, noseRadius } from "../kernel/insert.ts";
import { inFrame } from "../kernel/convex.ts";
import { positive } from "../kernel/geometry/segments.ts";
import { issue, type Issue } from "../kernel/issue.ts";
import type { Plan } from "../kernel/plan.ts";
import type { Segment } from "../kernel/point.ts";
import type { Tool } from "../kernel/tool.ts";
import { inDegrees, type Length, roundedAngle } from "../kernel/units.ts";
import { ROUND } from "../kernel/tolerance.ts";

/** Rounding of angles, radians. */
const ANGLE = 1e-6;

/**
 * Straight elements whose direction the nose cannot take, because a flank of the insert touches first. `names[i]` is the
 * Q of segment i; `asValue` turns a direction (degrees against the cutting direction, positive rising) into a value of that Q.
 */
export function angleIssues(
  contour: readonly Segment[],
  names: readonly string[],
  tool: Tool,
  frame: Frame,
  asValue: (q: string, direction: number) => number,
): Issue[] {
  const shape = inFrame(insertShape(tool), frame);
  const edgeAt = (i: number) => (shape[(i + shape.length) % shape.length]?.feature === "mainEdge" ? "mainEdge" : "secondaryEdge");
  const normals = shape.flatMap((
    e,
    i,
  ) => (e.kind === "arc" && e.feature === "nose"
    ? [{ from: normalStart(e) + Math.PI, width: normalEnd(e) - normalStart(e), edges: [edgeAt(i - 1), edgeAt(i + 1)] as const }]
    : [])
  );
  const width = shape.filter((e) => e.feature === "width").map((e) => normalStart(e) + Math.PI);
  const reached = (a: number) =>
    normals.some((n) => positive(a - n.from + ANGLE) <= n.width + 2 * ANGLE) || width.some((w) => Math.abs(Math.sin((a - w) / 2)) < ANGLE);
  const found = new Map<string, Issue>();
  contour.forEach((segment, i) => {
    if (segment.kind !== "line") return;
    const n = normalAt(segmentToFlat(frame, segment), "from");
    const a = Math.atan2(n.v, n.u);
    const name = names[i] ?? "contour";
    if (reached(a) || found.has(name)) return;
    const direction = inDegrees(a) - 90;
    const bounds = normals.flatMap((x) => [{ at: x.from, edge: x.edges[0] }, { at: x.from + x.width, edge: x.edges[1] }]).map((b) => ({
      at: inDegrees(Math.atan2(Math.sin(b.at), Math.cos(b.at))) - 90,
      edge: b.edge,
    }));
    const { at: max, edge } = bounds.reduce((best, b) => (Math.abs(b.at - direction) < Math.abs(best.at - direction) ? b : best),
      bounds[0] ?? { at: 0, edge: "mainEdge" });
    const nearest = roundedAngle(asValue(name, max));
    found.set(name, issue("angleNotFollowed", "warning", {
      angle: asValue(name, direction),
      max: asValue(name, max),
      nearest,
      edge,
    }, name));
  });
  return [...found.values()];
}

/** A programmed corner radius that the insert is too round for. */
export function cornerIssue(corner: Length, tool: Tool): Issue[] {
  const insert = noseRadius(tool);
  return corner > 0 && corner < insert - ROUND
    ? [issue("cornerSmallerThanInsert", "warning", { radius: corner, insert, nearest: insert }, "Q500")]
    : [];
}

/** A plan with what its tool cannot follow; a tool that is unfit altogether needs no details. */
export const withIssues = (plan: Plan, found: readonly Issue[]): Plan =>
  plan.issues.some((i) => i.code === "toolUnfit") ? plan : { ...plan, issues: [...plan.issues, ...found] };
