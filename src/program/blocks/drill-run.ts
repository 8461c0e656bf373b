import { depthAtRadius, isDrill, pointLength } from "../../kernel/cutter/drill.ts";
import type { Move } from "../../kernel/plan/move.ts";
import { at as pointAt, type Pt } from "../../kernel/geometry/point.ts";
import type { NeededHole } from "../../kernel/time/step.ts";
import { speedAt } from "../../kernel/time/time.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { feed as feedNumber, perSide, toDiameter, diameter, type Feed } from "../../kernel/units.ts";
import { isUnlikely } from "../state/block-feed.ts";
import { drillPath, holeBefore, type Bore, type DrillFeed, type DrillMove, type Q } from "./drill-path.ts";
import { DRILL_WORDS, drillQuantity } from "./drill-words.ts";
import { programIssue } from "../state/issue.ts";
import type { Machine } from "../state/machine.ts";
import type { Defined } from "../state/modal.ts";
import { offCentre } from "../motion/off-centre.ts";
import { lineOfParameter } from "../state/preconditions.ts";
import { requireSpindle } from "./spindle-start.ts";

/** Distance from the axis within which a drill counts as centred, mm. */
const ON_AXIS = 0.001;
/** The cycle that only centres. */
const CENTRING = 240;
/** This feed value means rapid. */
const AS_RAPID = 99_999;

/**
 * Runs a drilling cycle on the axis of the turning spindle. False where the cycle is not simulated: off the axis,
 * without a drill, or with values that make no bore.
 */
export function drillOnAxis(machine: Machine, defined: Defined, index: number): boolean {
  const { tool } = machine.now;
  const {
    tip,
    place: { sure },
  } = machine;
  const needed = DRILL_WORDS.get(defined.cycle);
  if (!machine.now.turning || !needed || !tool || !isDrill(tool) || !tip || !sure.x || !sure.z) return false;
  if (Math.abs(tip.r) > ON_AXIS || needed.some((q) => value(machine, defined, q) === null)) return false;
  const q: Q = (name) => {
    const n = value(machine, defined, name) ?? 0;
    return drillQuantity(defined.cycle, name)?.kind === "length" ? machine.length(n) : n;
  };
  const bore = boreOf(defined, tool, q, machine.now.datum.z);
  const path = bore && drillPath(defined.cycle, q, bore);
  if (!bore || !path) return false;
  judge(machine, { defined, tool, bore, q }, index);
  // The sign of the pitch gives the hand of the thread.
  requireSpindle(machine, tool, index, { leftHand: q("Q239") === 0 ? undefined : q("Q239") < 0 });
  offCentre(machine, index);
  perform(machine, { defined, path, hole: holeBefore(defined.cycle, tool, q) }, tip, index);
  return true;
}

/** A number of the definition; rapid and the feed of the tool call count as numbers. Null when missing. */
function value(machine: Machine, { values, index }: Defined, name: string): number | null {
  const n = values.get(name);
  if (n === "auto") return machine.now.toolFeed;
  if (typeof n === "number") return n;
  const s = machine.blocks[index]?.statement;
  const written = s?.kind === "cycle" ? s.parameters.find((p) => p.q === name)?.value : undefined;
  return written === "max" ? AS_RAPID : null;
}

/** Position of the bore; null when its depth does not point down. */
function boreOf({ cycle }: Defined, tool: Tool, q: Q, datum: number): Bore | null {
  const surface = q("Q203") + datum;
  const byDiameter = cycle === CENTRING && q("Q343") === 1;
  const depth = byDiameter ? depthAtRadius(tool, perSide(diameter(Math.abs(q("Q344"))))) : -q("Q201");
  if (depth === null || !(depth > 0) || q("Q200") < 0) return null;
  // Q395 = 1: the depth is that of the full radius.
  const point = q("Q395") === 1 && !byDiameter ? pointLength(tool) : 0;
  return { surface, bottom: surface - depth - point, clear: surface + q("Q200"), away: surface + q("Q204") };
}

interface Judged {
  readonly defined: Defined;
  readonly tool: Tool;
  readonly bore: Bore;
  readonly q: Q;
}

/** Reports values that the tool cannot machine or that are surely a typing error. */
function judge(machine: Machine, { defined, tool, bore, q }: Judged, index: number): void {
  const raw = machine.blocks[defined.index]?.raw ?? "";
  const say = (issue: Parameters<typeof machine.log.report>[0], at: string) =>
    machine.log.report(issue, defined.index, lineOfParameter(raw, at));
  const edges = tool.CUTLENGTH;
  const [depth, point] = [bore.surface - bore.bottom, pointLength(tool)];
  if (edges !== undefined && depth > edges + SAME)
    machine.log.report(programIssue("drillTooShort", "warning", { depth, edges }, "tool"), index);
  if (tool.TYPE === "DRILL" && defined.cycle !== CENTRING && point > depth + SAME)
    say(programIssue("pointBeyondDepth", "warning", { point, depth }, "Q201"), "Q201");
  const tapping = DRILL_WORDS.get(defined.cycle)?.includes("Q239");
  const pitch = Math.abs(q("Q239"));
  if (tapping && tool.PITCH !== undefined && Math.abs(tool.PITCH - pitch) > SAME)
    say(programIssue("pitchOfTap", "error", { pitch, tap: tool.PITCH }, "Q239"), "Q239");
  if (tapping) return;
  const feed = q("Q206");
  if (!(feed > 0)) say(programIssue("feedZero", "error", { word: `Q206=${feed}` }, "Q206"), "Q206");
  else if (feed < AS_RAPID && isUnlikely(machine.feedOf(feed), machine.now.perRevolution))
    say(
      programIssue("feedUnlikely", "warning", { feed: machine.feedOf(feed), unit: machine.feedUnit }, "Q206"),
      "Q206",
    );
}

const purpose = { run: "rough", step: 0 } as const;

/** A feed of the cycle; null is rapid. A retraction feed of 0 means the plunging feed. */
function feedOf(machine: Machine, defined: Defined, feed: Exclude<DrillFeed, { pitch: number }>): Feed | null {
  const own = value(machine, defined, feed.q) ?? (feed.q === "Q253" ? AS_RAPID : 0);
  const n = own === 0 && feed.q === "Q208" ? (value(machine, defined, "Q206") ?? 0) : own;
  return n >= AS_RAPID ? null : machine.feedOf(n);
}

function moveOf(machine: Machine, defined: Defined, { to, feed }: DrillMove, from: Pt): Move {
  const end = pointAt(to, from.r);
  const phase = feed && to < from.z ? "rough" : "position";
  if (feed && "pitch" in feed)
    return { kind: "feed", to: end, feed: feedNumber(feed.pitch), feedUnit: "mm/rev", phase, ...purpose };
  const n = feed && feedOf(machine, defined, feed);
  if (n === null) return { kind: "rapid", to: end, phase: "position", ...purpose };
  return { kind: "feed", to: end, feed: n, feedUnit: machine.feedUnit, phase, ...purpose };
}

function perform(
  machine: Machine,
  {
    defined,
    path,
    hole,
  }: { readonly defined: Defined; readonly path: readonly DrillMove[]; readonly hole: NeededHole | null },
  start: Pt,
  index: number,
): void {
  let from = start;
  const { spindle } = machine;
  for (const each of path) {
    const move = moveOf(machine, defined, each, from);
    if (Math.abs(each.to - from.z) > SAME) machine.step(from, move, index, { hole });
    from = move.to;
    const turns = spindle && each.dwell ? (each.dwell / 60) * speedAt(spindle, from.r) : 0;
    if (turns > 0 && Number.isFinite(turns)) {
      machine.step(
        from,
        {
          kind: "feed",
          to: from,
          feed: feedNumber(0),
          feedUnit: machine.feedUnit,
          dwell: turns,
          phase: "position",
          ...purpose,
        },
        index,
      );
    }
  }
  machine.setPlace({ at: { x: toDiameter(from.r), y: null, z: from.z }, last: null });
}
