import type { Cycle, Given } from "../../cycles/define.ts";
import { cycleByNumber } from "../../cycles/index.ts";
import { issue, type Issue } from "../../kernel/plan/issue.ts";
import { partPoint } from "../../kernel/plane/plane.ts";
import type { StatementOf } from "../../nc/statement.ts";
import type { CycleParameter } from "../../nc/words.ts";
import type { Pt } from "../../kernel/geometry/point.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { callResult } from "./call-result.ts";
import { readContourOf } from "./contour-subprogram.ts";
import { cycleValues } from "./cycle-values.ts";
import { drillOnAxis } from "./drill-run.ts";
import { isDrilling } from "./drill-words.ts";
import { programIssue, type ProgramIssue } from "../state/issue.ts";
import type { UnknownReason } from "../values/known-values.ts";
import type { Machine } from "../state/machine.ts";
import type { Defined } from "../state/modal.ts";
import { pointIn } from "../state/path.ts";
import { offCentre } from "../motion/off-centre.ts";
import { foreignParameters, lineOfParameter, noTool } from "../state/preconditions.ts";
import { perform } from "./perform.ts";
import type { TextLine } from "../state/run-types.ts";
import { callNamed } from "./program-calls.ts";
import { countedPoint } from "./shifted-plan.ts";
import { solidAtCall, stockAtCall } from "./stock-at-call.ts";
import { requireSpindle } from "./spindle-start.ts";
import { startUnknown } from "../motion/turn-run.ts";
import { actingCycle, actsAtOnce, isSilent } from "./unproved-blocks.ts";
import { rankTools } from "../tools/which-tool.ts";

interface ReadContour extends Pick<Given, "contour"> {
  /**
   * Contour issues reported at their blocks; null where an unread block makes all other issues of the contour
   * meaningless.
   */
  readonly reportedCodes: readonly Issue["code"][] | null;
  /** Block and element number of each segment, in programmed order. */
  readonly places: readonly { readonly block: number; readonly element: number }[];
}

/** A missing or unreadable contour is reported where it is found. */
const NO_CONTOUR: ReadContour = { contour: null, reportedCodes: null, places: [] };
/** A cycle without a contour. */
const OWN_CONTOUR: ReadContour = { contour: null, reportedCodes: [], places: [] };

/** Contour that cycle 14 names, with its issues reported at their blocks. */
function givenContour(machine: Machine, cycle: number, index: number, operation: number): ReadContour {
  const { contours } = machine.now;
  if (contours === "unknown") {
    machine.log.leaveUnproved("CYCL CALL", index);
    return NO_CONTOUR;
  }
  if ("joined" in contours) {
    machine.log.report(programIssue("contoursJoined", "warning", { cycle, joined: contours.joined }), contours.index);
    machine.log.leaveUnproved("CYCL CALL", index);
    return NO_CONTOUR;
  }
  if (contours.length === 0) {
    const { contourFile: file } = machine.now;
    machine.log.report(
      file === null
        ? programIssue("contourNotNamed", "error", { cycle })
        : programIssue("contourInFile", "error", { file }),
      index,
    );
    return NO_CONTOUR;
  }
  const read = contours.map((source) => readContourOf(machine, source, index));
  // An unread block is the cause of all other issues of the contour.
  for (const r of read)
    for (const i of r && !r.isTroubled ? r.contour.issues : []) {
      const element = "element" in i.data ? i.data.element : 0;
      machine.log.report(i, r?.blocks[element - 1] ?? index, 0, operation);
    }
  // A single contour keeps its identity, so cached results stay valid.
  const [only] = read;
  const segments = read.length === 1 ? (only?.contour.segments ?? []) : read.flatMap((r) => r?.contour.segments ?? []);
  const places = read.flatMap(
    (r) => r?.contour.elements.map((element) => ({ element, block: r.blocks[element - 1] ?? index })) ?? [],
  );
  const isTroubled = read.some((r) => r?.isTroubled ?? true);
  const reportedCodes = isTroubled ? null : read.flatMap((r) => r?.contour.issues ?? []).map((i) => i.code);
  return { contour: segments.length > 0 ? segments : null, reportedCodes, places };
}

/** Places an issue of a contour segment at the number and block of its element, every other issue at the call. */
function atElement<F extends Issue | ProgramIssue>(
  found: F,
  places: ReadContour["places"],
  call: number,
): { readonly said: F; readonly block: number } {
  const { element, other } = found.data as { readonly element?: unknown; readonly other?: unknown };
  const placeOf = (segment: unknown) =>
    found.at === "contour" && typeof segment === "number" ? places[segment - 1] : undefined;
  const [place, second] = [placeOf(element), placeOf(other)];
  if (!place) return { said: found, block: call };
  return {
    said: { ...found, data: { ...found.data, element: place.element, ...(second && { other: second.element }) } },
    block: place.block,
  };
}

/**
 * A program section without a tool call is still shown, with the tool that machines most of its contour. The missing
 * call is reported as an error.
 */
function fallbackTool(
  machine: Machine,
  cycle: Cycle,
  given: Defined["values"],
  contour: Given["contour"],
  at: Pt,
  index: number,
): Tool | null {
  const { values } = cycleValues(machine, cycle, given);
  if (!values || (cycle.contour === "free" && !contour)) return null;
  const start = countedPoint(at, machine.now.datum);
  const best = rankTools(
    cycle,
    values,
    { contour, start },
    {
      start,
      feedUnit: machine.feedUnit,
      autoFeed: machine.now.toolFeed,
      stock: null,
    },
    machine.shop.tools,
  )[0]?.tool;
  if (best) machine.log.report(issue("betterTool", "info", { tool: best.T, name: best.NAME }, "tool"), index);
  return best ?? null;
}

/** Preconditions of a cycle call, apart from its values. */
function preconditions(machine: Machine, index: number): void {
  if (machine.now.mode !== "TURN") machine.log.report(programIssue("notInTurnMode", "error", {}), index);
  if (machine.now.compensation !== "R0")
    machine.log.report(programIssue("compensationActive", "error", { side: machine.now.compensation }), index);
  if (!machine.now.tool) noTool(machine, index);
}

/** Tip at the call, in workpiece coordinates. While milling, X words are read as the intended diameters. */
function startOf(machine: Machine, index: number): Pt | null {
  if (!machine.now.turning) return pointIn("lathe", machine.place.mill);
  // With RL or RR still active the tip is off the programmed point.
  const really = machine.now.compensation === "R0" ? null : machine.turnGuide.here;
  const start = really && machine.tip ? partPoint(really) : machine.tip;
  if (start && (!machine.place.sure.x || !machine.place.sure.z)) {
    // The plan starts at the previous tool position, which proves nothing.
    machine.log.report(programIssue("startUnknown", "warning", {}), index);
    machine.log.leaveUnproved("CYCL CALL", index);
  } else if (!start && machine.place.lostReason === "unproved") machine.log.leaveUnproved("CYCL CALL", index);
  else if (!start) startUnknown(machine, index);
  return start;
}

/** Another cycle is kept but not simulated: its effect on the workpiece is unknown. */
function otherCycle(machine: Machine, { index: definedIn, cycle }: Defined, index: number): void {
  const s = machine.blocks[definedIn]?.statement;
  const name = s?.kind === "cycle" ? s.name : s?.kind === "cycleLine" ? s.text : "";
  machine.log.leaveUnproved(`CYCL DEF ${cycle} ${name}`.trim(), index);
}

/** Executes a cycle call: plans the defined cycle from where the tip stands and runs its moves. */
export function callCycle(machine: Machine, index: number): void {
  const { defined } = machine.now;
  if (!defined) return machine.log.report(programIssue("noCycleDefined", "error", {}), index);
  machine.markCalled(defined.index);
  if (defined.program !== undefined) return callNamed(machine, defined.program, `CYCL DEF ${defined.cycle}`, index);
  const cycle = cycleByNumber(defined.cycle);
  if (!cycle) return drillOnAxis(machine, defined, index) ? undefined : otherCycle(machine, defined, index);
  preconditions(machine, index);
  const start = startOf(machine, index);
  if (!start) return;
  if (!machine.roomForOperation(index)) return;
  const operation = machine.log.operations.length;
  const { places, contour, reportedCodes } =
    cycle.contour === "free" ? givenContour(machine, cycle.number, index, operation) : OWN_CONTOUR;
  const tool = machine.now.tool ?? fallbackTool(machine, cycle, defined.values, contour, start, index);
  if (!tool) return;
  requireSpindle(machine, tool, index, { operation });
  offCentre(machine, index);
  const standing = { stock: stockAtCall(machine), solid: solidAtCall(machine) };
  const answer = callResult(machine, { cycle, defined, contour, reportedCodes, start, tool, ...standing });
  const contourLines = contour && { contourLines: places.map(({ block }) => lineAt(machine, block)) };
  perform(machine, { cycle: cycle.number, defined, answer, start, tool, ...contourLines }, index);
  const where = machine.blocks[defined.index]?.raw ?? "";
  for (const i of answer.reported) {
    const parameter = i.at?.startsWith("Q") ? i.at : null;
    const placed = atElement(i, places, index);
    if (parameter) machine.log.report(i, defined.index, lineOfParameter(where, parameter), operation);
    else machine.log.report(placed.said, placed.block, 0, operation);
  }
}

/** First line of a block in its own text. */
function lineAt(machine: Machine, block: number): TextLine {
  const { line, file } = machine.log.placeOf(block);
  return { line, ...(file !== undefined && { file }) };
}

/** Parameters of a definition at this moment, and why some are unknown. */
interface Parameters {
  readonly values: Map<string, number | "auto" | null>;
  readonly unknownParameters: ReadonlyMap<string, UnknownReason>;
}

function readParameters(machine: Machine, parameters: readonly CycleParameter[], index: number): Parameters {
  const values = new Map<string, number | "auto" | null>();
  const unknownParameters = new Map<string, UnknownReason>();
  for (const p of parameters) {
    if (p.value === null || p.value === "max") values.set(p.q, null);
    else if (p.value === "auto") values.set(p.q, "auto");
    else {
      const n = machine.number(p.value, index);
      values.set(p.q, n);
      if (n === null) unknownParameters.set(p.q, machine.known.lastUnknownReason);
    }
  }
  return { values, unknownParameters };
}

/**
 * Default values that a control adds to a list of older software. Reported once per program: its lists come from one
 * machine.
 */
function fillIn(machine: Machine, cycle: Cycle, values: Map<string, number | "auto" | null>, index: number): void {
  const filled: string[] = [];
  for (const [q, { filledIn }] of Object.entries(cycle.params)) {
    if (filledIn === null || values.has(q)) continue;
    values.set(q, filledIn);
    filled.push(`${q}=${filledIn}`);
  }
  if (filled.length > 0)
    machine.log.reportOnce(programIssue("listOfOlderSoftware", "info", { cycle: cycle.number, filled }), index);
}

/** A cycle that acts at its definition. Invalid values are reported; missing ones are those of an older control. */
function act(machine: Machine, cycle: Cycle, s: StatementOf<"cycle">, index: number): void {
  const { issues } = cycleValues(machine, cycle, readParameters(machine, s.parameters, index).values);
  const raw = machine.blocks[index]?.raw ?? "";
  for (const i of issues)
    if (i.code !== "missing" && i.at !== undefined) machine.log.report(i, index, lineOfParameter(raw, i.at));
}

/**
 * Activates a definition. As on the control, parameters are read now and stored in the Q parameters of their number.
 */
export function cycleDefinition(machine: Machine, index: number): void {
  const s = machine.blocks[index]?.statement;
  if (s?.kind !== "cycle") return;
  const cycle = cycleByNumber(s.cycle);
  // Whether a drilling cycle is simulated shows at its call.
  const bores = machine.now.turning && isDrilling(s.cycle);
  if (!cycle && !bores && !isSilent(s.cycle))
    machine.log.report(programIssue("cycleNotSimulated", "info", { cycle: s.cycle, name: s.name }), index);
  // It may reverse the tool.
  if (cycle?.acts) machine.set({ spindleDirections: new Map() });
  if (cycle?.acts) act(machine, cycle, s, index);
  if (actsAtOnce(s.cycle)) return actingCycle(machine, s.cycle, s.parameters, index);
  const { values, unknownParameters } = readParameters(machine, s.parameters, index);
  if (cycle) fillIn(machine, cycle, values, index);
  values.forEach((v, q) => typeof v === "number" && machine.known.set(q, v));
  unknownParameters.forEach((reason, q) => machine.known.markUnknown(q, reason));
  if (cycle || bores) machine.markDefined(index);
  if (cycle)
    foreignParameters(
      machine,
      cycle,
      s.parameters.map((p) => p.q),
      index,
    );
  machine.set({
    callsBehindMoves: false,
    defined: { index, cycle: s.cycle, values, unknownParameters: new Set(unknownParameters.keys()) },
  });
}
