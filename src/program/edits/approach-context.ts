import { plane, type PlanePoint, type PlaneSegment, type Side } from "../../kernel/plane/plane.ts";
import { diameter, INCH, toRadius } from "../../kernel/units.ts";
import type { Program } from "../../nc/program.ts";
import type { AxisName } from "../../nc/words.ts";
import type { WorkingPlane } from "../motion/approach-fields.ts";
import type { ApproachContext } from "./approach-request.ts";
import { growthIn, isFlipped, NO_TRANSFORM, toProgram } from "../tools/coordinates-frame.ts";
import { valueOf } from "../values/formula.ts";
import type { KnownParameters } from "../values/expression.ts";
import type { ApproachRun } from "../tools/plane-types.ts";
import type { Run } from "../state/run-types.ts";

const { difference, shifted, sum } = plane;

/** Modal state at a block, read from the preceding text. */
interface InForce {
  readonly turning: boolean;
  readonly inch: boolean;
  readonly pole: PlanePoint | null;
}

function inForce(program: Program, index: number, parameters: KnownParameters): InForce {
  let [turning, inch] = [false, false];
  let pole: PlanePoint | null = null;
  const known = new Map(Object.entries(parameters));
  for (const { statement: s } of program.blocks.slice(0, index)) {
    if (s.kind === "begin") inch = s.unit === "INCH";
    if (s.kind === "mode") turning = s.mode === "TURN";
    if (s.kind !== "path" || s.path !== "CC") continue;
    const coordinate = (axis: AxisName) => {
      const word = s.words.axes.find((w) => w.axis === axis && !w.incremental);
      const value = word && valueOf(word.value, known);
      return typeof value === "number" ? value * (inch ? INCH : 1) : null;
    };
    const [x, y, z] = [coordinate("X"), coordinate("Y"), coordinate("Z")];
    if (turning && x !== null && z !== null) pole = { x: z, y: toRadius(diameter(x)) };
    else if (!turning && x !== null && y !== null) pole = { x, y };
    else pole = null;
  }
  return { turning, inch, pole };
}

function feedBefore(run: Run, index: number, plane: WorkingPlane): ApproachContext["feedBefore"] {
  if (plane === "XY") {
    const first = run.plane.find((step) => step.index === index);
    return first ? (first.kind === "rapid" ? "rapid" : (first.feed ?? null)) : null;
  }
  const move = run.steps[run.stepBlocks.indexOf(index)]?.move;
  return !move || move.kind === "thread" ? null : move.kind === "rapid" ? "rapid" : move.feed;
}

/** Converts workpiece coordinates to those of the words of an APPR or DEP block. */
function countingOf(found: ApproachRun | undefined) {
  const by = found ? difference(NO_TIP, found.datum) : NO_TIP;
  if (!found || found.transform === NO_TRANSFORM)
    return {
      point: (p: PlanePoint) => sum(p, by),
      segment: (s: PlaneSegment) => shifted(s, by),
      side: (s: Side) => s,
      growth: 1,
    };
  const { transform, datum } = found;
  const point = (p: PlanePoint): PlanePoint => {
    const { x, y } = toProgram({ shift: { ...datum, z: 0 }, transform }, { ...p, z: 0 });
    return { x: x ?? 0, y: y ?? 0 };
  };
  const flipped = isFlipped(transform, "XY");
  const segment = (s: PlaneSegment): PlaneSegment => {
    const ends = { from: point(s.from), to: point(s.to) };
    if (s.kind === "line") return { ...s, ...ends };
    return { ...s, ...ends, centre: point(s.centre), turn: flipped ? (s.turn === "cw" ? "ccw" : "cw") : s.turn };
  };
  const side = (s: Side): Side => (!flipped || s === "none" ? s : s === "left" ? "right" : "left");
  return { point, segment, side, growth: growthIn(transform, "XY") ?? 1 };
}

const NO_TIP: PlanePoint = { x: 0, y: 0 };

/** Surroundings of the APPR or DEP block at `index`: from the last run, else from the text. */
export function approachContext(
  program: Program,
  index: number,
  run: Run | null,
  parameters: KnownParameters,
): ApproachContext {
  const { turning, inch, pole } = inForce(program, index, parameters);
  const statement = program.blocks[index]?.statement;
  const departing = statement?.kind === "approach" && statement.departing;
  const found: ApproachRun | undefined = run?.approaches.findLast(
    (a) => a.index === index && a.departing === departing,
  );
  const plane = found?.plane ?? (turning ? "ZX" : "XY");
  // The words of the block count from the datum of the program.
  const count = countingOf(found);
  const outside = found && !departing ? found.request.outside : null;
  return {
    plane,
    pole,
    parameters,
    unit: inch ? INCH : 1,
    before: outside && count.point(outside),
    contour: found?.contour.map(count.segment) ?? [],
    side: count.side(found?.side ?? "left"),
    toolRadius: (found?.toolRadius ?? 0) / count.growth,
    tip: found?.tip ?? NO_TIP,
    feedBefore: run ? feedBefore(run, index, plane) : null,
  };
}
