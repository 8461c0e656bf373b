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

/** A contour with the Q of each segment, or with the index of each segment in a programmed contour, from 1. */
interface Named {
  readonly contour: readonly Segment[];
  readonly names?: readonly string[];
  readonly elements?: readonly number[];
}

/** An angle in degrees, above −180 and up to 180. */
const halfTurns = (degrees: number) => 180 - ((((180 - degrees) % 360) + 360) % 360);

/**
 * Straight elements whose direction the nose cannot follow, because a flank of the insert touches first; for each Q, or
 * in a programmed contour, the element that exceeds the limit most. An element that leans over the cut is behind the
 * contour for every tool, since the tip comes from the open side. `asValue` turns a direction (degrees against the
 * cutting direction, positive rising) into a value of a Q.
 */
export function angleIssues(
  { contour, names, elements }: Named,
  tool: Tool,
  frame: Frame,
  asValue: (q: string, direction: number) => number,
): Issue[] {
  const shape = inFrame(insertShape(tool), frame);
  const edgeAt = (i: number) => {
    // Residual material beside a bar is attributed to its width as well.
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
    const { at: max, edge: touching } = bounds.reduce(
      (best, b) => (Math.abs(b.at - direction) < Math.abs(best.at - direction) ? b : best),
      bounds[0] ?? { at: 0, edge: "mainEdge" },
    );
    const edge = n.v < -ANGLE ? ("behindContour" as const) : touching;
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

/** A programmed corner radius that is smaller than the nose radius. */
export function cornerIssue(corner: Length, tool: Tool): Issue[] {
  const insert = noseRadius(tool);
  return corner > 0 && corner < insert - ROUND
    ? [issue("cornerSmallerThanInsert", "warning", { radius: corner, insert }, "Q500")]
    : [];
}

/** A plan with angle issues of its tool; a tool that is unfit altogether needs no details. */
export const withIssues = (plan: Plan, found: readonly Issue[]): Plan =>
  plan.issues.some((i) => i.code === "toolUnfit") ? plan : { ...plan, issues: [...plan.issues, ...found] };
