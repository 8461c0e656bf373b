import type { Move } from "../kernel/plan/move.ts";
import type { Pt, Ring } from "../kernel/geometry/point.ts";
import type { Step } from "../kernel/time/step.ts";
import type { Tool } from "../kernel/plan/tool.ts";

const samePoint = (a: Pt, b: Pt): boolean => a.z === b.z && a.r === b.r;

/** True for the same rings by value. */
export const sameRings = (a: readonly Ring[], b: readonly Ring[]): boolean =>
  a === b ||
  (a.length === b.length &&
    a.every((ring, i) => {
      const other = b[i] as Ring;
      return ring.length === other.length && ring.every((p, k) => samePoint(p, other[k] as Pt));
    }));

/** Whether two moves cut the same; the feed does not matter. */
function sameMove(a: Move, b: Move): boolean {
  if (a.kind !== b.kind || a.phase !== b.phase || a.pass !== b.pass || !samePoint(a.to, b.to)) return false;
  if (a.kind === "arc" && b.kind === "arc") return a.turn === b.turn && samePoint(a.centre, b.centre);
  if (a.kind === "thread" && b.kind === "thread")
    return a.pitch === b.pitch && a.axis === b.axis && a.angle === b.angle && a.stops === b.stops;
  return true;
}

/** Compares steps by their effect on the stock. Tools are compared by value, each pair once. */
export function sameSteps(): (a: Step, b: Step) => boolean {
  const written = new WeakMap<Tool, string>();
  const writing = (tool: Tool): string => {
    const known = written.get(tool) ?? JSON.stringify(tool);
    written.set(tool, known);
    return known;
  };
  const sameTool = (a: Tool, b: Tool): boolean => a === b || writing(a) === writing(b);
  const sameBringing = (a: Step, b: Step): boolean => (a.positionedBy === undefined) === (b.positionedBy === undefined);
  const sameDemand = (a: Step, b: Step): boolean =>
    a.spindleFault?.how === b.spindleFault?.how &&
    a.spindleFault?.by === b.spindleFault?.by &&
    a.hole?.radius === b.hole?.radius;
  return (a, b) =>
    a === b ||
    (a.operation === b.operation &&
      a.intent === b.intent &&
      sameDemand(a, b) &&
      sameBringing(a, b) &&
      samePoint(a.from, b.from) &&
      sameMove(a.move, b.move) &&
      sameTool(a.tool, b.tool));
}
