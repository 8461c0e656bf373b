import { holeOf, isDrill } from "../../kernel/cutter/drill.ts";
import type { Idle, NeededHole } from "../../kernel/time/step.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { Modal } from "./modal.ts";

/**
 * Whether a tool cuts backwards; undefined where nobody knows. A drill cuts forwards, any other edge the way in which
 * it has cut before. A tap may be a left-hand one, and leaves its thread with the spindle turning back.
 */
const cutsBackwards = ({ ways }: Modal, tool: Tool): boolean | undefined =>
  isDrill(tool) ? (tool.TYPE === "TAP" ? undefined : false) : ways.get(tool.T);

/** What a run knows beside what is in force: how much it has left unproved so far, and the number of each block. */
interface Known {
  readonly unproved: { readonly length: number };
  numberOf(index: number): number | undefined;
}

/**
 * Why the spindle surely does not turn as a cut with a tool needs it; null where it does. Silent where blocks came
 * before that nobody here knows: any of them may have started the spindle, or set a speed. `wanted`: whether the cut
 * needs it backwards, as its cycle says.
 */
export function idleSpindle(now: Modal, known: Known, tool: Tool, wanted = cutsBackwards(now, tool)): Idle | null {
  const { unproved } = known;
  const { mode, spindle, turns, backwards, spun, speedElsewhere } = now;
  if (mode !== "TURN") return null;
  const by = spun.index === null ? null : (known.numberOf(spun.index) ?? null);
  const stands = !turns && unproved.length <= spun.unproved;
  const hasSpeed = spindle || speedElsewhere === "told" || (speedElsewhere === "toolCall" && isDrill(tool));
  if (!hasSpeed && unproved.length === 0 && (by === null || !stands)) return { how: "noSpeed", by: null };
  if (stands) return { how: "stopped", by };
  return turns && wanted !== undefined && wanted !== backwards ? { how: "hand", by } : null;
}

/** What is known of a motion beside its way: it is compensated, or a hole has to be there for it. */
export interface GivenForStep {
  readonly isCompensated?: boolean;
  readonly hole?: NeededHole | null;
}

/** What a feed move asks of spindle and stock; a spindle that has been told is not told again. */
export function demands(
  now: Modal,
  known: Known,
  tool: Tool,
  hole: NeededHole | null,
): { readonly idle?: Idle; readonly hole?: NeededHole } {
  const idle = now.spun.told ? null : idleSpindle(now, known, tool);
  const needed = hole ?? holeOf(tool);
  return { ...(idle && { idle }), ...(needed && { hole: needed }) };
}
