import type { Cycle } from "../cycles/define.ts";
import { issue, type Issue } from "../kernel/issue.ts";
import type { Plan } from "../kernel/plan.ts";
import type { Spindle } from "../kernel/step.ts";
import { axisRate, speedAt, type RapidRate } from "../kernel/time.ts";
import { roundedUp } from "../kernel/units.ts";

/** Revolutions per minute times lead, over this, are the mm that an axis needs to get up to the feed: a rule of thumb of the trade. */
const RUN_IN = 400;

/**
 * What the speed of the spindle makes of a thread: a feed that the axis cannot follow (it goes no faster than at rapid), a run-in too
 * short to get up to it. Each at its parameter.
 */
export function threadWarnings({ params }: Cycle, { thread, moves }: Plan, spindle: Spindle | null, rapid: RapidRate): Issue[] {
  const first = moves.findIndex((m) => m.kind === "thread");
  const before = moves[first - 1], turned = moves[first];
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
    found.push(issue("threadFeedOverLimit", "warning", { ...whole, most, upTo: Math.floor(most / thread.lead) }, shown("pitch")));
  const needed = roundedUp(feed / RUN_IN);
  if (thread.runIn < needed) {
    const at = shown("runIn", "clearance");
    const longest = at === undefined ? 0 : (params[at]?.range[1] ?? 0);
    const data = { runIn: thread.runIn, needed, speed: whole.speed, ...(needed <= longest && { nearest: needed }) };
    found.push(issue("runInShort", "warning", data, at));
  }
  return found;
}
