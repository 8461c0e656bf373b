import type { Cycle } from "../../cycles/define.ts";
import { issue, type Issue } from "../../kernel/plan/issue.ts";
import type { Plan } from "../../kernel/plan/plan.ts";
import type { Spindle } from "../../kernel/time/step.ts";
import { axisRate, speedAt, type RapidRate } from "../../kernel/time/time.ts";
import { RUN_IN_STEP } from "../../kernel/strategy/thread-run-in.ts";
import { roundedUp, roundedUpTo } from "../../kernel/units.ts";

/** Run-in in mm = rpm × lead / this value: a rule of thumb of the trade for the axis to reach its feed. */
const RUN_IN = 400;

/** With constant surface speed each pass starts at another angle. Reported regardless of other faults of the thread. */
function surfaceSpeed(spindle: Extract<Spindle, { kind: "surface" }>, moves: Plan["moves"]): Issue {
  const speeds = moves.flatMap((m, i) =>
    m.kind === "thread" ? [moves[i - 1]?.to.r ?? m.to.r, m.to.r].map((r) => speedAt(spindle, r)) : [],
  );
  const [slow, fast] = [Math.round(Math.min(...speeds)), Math.round(Math.max(...speeds))];
  const { cuttingSpeed } = spindle;
  return issue("threadSurfaceSpeed", "warning", fast > slow ? { cuttingSpeed, slow, fast } : { cuttingSpeed });
}

/**
 * Thread warnings about the spindle speed: constant surface speed, a feed beyond the rapid rate of the axis, a run-in
 * too short to reach the feed. The last two at their parameters.
 */
export function threadWarnings(cycle: Cycle, plan: Plan, spindle: Spindle | null, rapid: RapidRate): Issue[] {
  const changing = cycle.thread && spindle?.kind === "surface" ? [surfaceSpeed(spindle, plan.moves)] : [];
  return [...changing, ...feedWarnings(cycle, plan, spindle, rapid)];
}

function feedWarnings({ params }: Cycle, { thread, moves }: Plan, spindle: Spindle | null, rapid: RapidRate): Issue[] {
  const first = moves.findIndex((m) => m.kind === "thread");
  const before = moves[first - 1],
    turned = moves[first];
  if (!thread || !spindle || !before || !turned) return [];
  const shown = (...topics: readonly string[]) =>
    topics.flatMap((topic) => Object.keys(params).filter((q) => params[q]?.shown === topic))[0];
  const speed = speedAt(spindle, before.to.r);
  if (!Number.isFinite(speed) || speed <= 0) return [];
  const found: Issue[] = [];
  const feed = speed * thread.lead;
  const whole = { feed: Math.round(feed), speed: Math.round(speed) };
  const most = axisRate(rapid, before.to, turned.to);
  if (feed > most)
    found.push(
      issue("threadFeedOverLimit", "warning", { ...whole, most, upTo: Math.floor(most / thread.lead) }, shown("pitch")),
    );
  const needed = roundedUp(feed / RUN_IN);
  if (thread.runIn < needed) {
    const at = shown("runIn", "clearance");
    const longest = at === undefined ? 0 : (params[at]?.range[1] ?? 0);
    const nearest = roundedUpTo(RUN_IN_STEP, needed);
    // At a speed that no run-in can reach, the speed has to change.
    const data = {
      runIn: thread.runIn,
      needed,
      speed: whole.speed,
      ...(nearest <= longest && feed <= most && { nearest }),
    };
    found.push(issue("runInShort", "warning", data, at));
  }
  return found;
}
