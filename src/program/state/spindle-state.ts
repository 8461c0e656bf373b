import { holeOf, isDrill } from "../../kernel/cutter/drill.ts";
import type { SpindleFault, NeededHole } from "../../kernel/time/step.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { Modal } from "./modal.ts";

/**
 * Whether a tool needs a reversed spindle; undefined while unknown. A drill cuts forwards, any other edge as in its
 * first cut. A tap may be left-hand, and retracts with the spindle reversed.
 */
const cutsBackwards = ({ spindleDirections }: Modal, tool: Tool): boolean | undefined =>
  isDrill(tool) ? (tool.TYPE === "TAP" ? undefined : false) : spindleDirections.get(tool.T);

/** Run data besides the modal state: number of unverified entries, and block numbers. */
interface Known {
  readonly unproved: { readonly length: number };
  numberOf(index: number): number | undefined;
}

/**
 * Why the spindle surely does not turn as a cut needs it; null where it does. Silent after unknown blocks: any of them
 * may have started the spindle or set a speed. `wanted`: whether the cut needs reverse, as its cycle says.
 */
export function spindleFaultOf(
  now: Modal,
  known: Known,
  tool: Tool,
  wanted = cutsBackwards(now, tool),
): SpindleFault | null {
  const { unproved } = known;
  const { mode, spindle, turns, backwards, spindleChange, speedElsewhere } = now;
  if (mode !== "TURN") return null;
  const by = spindleChange.index === null ? null : (known.numberOf(spindleChange.index) ?? null);
  const stands = !turns && unproved.length <= spindleChange.unproved;
  const hasSpeed = spindle || speedElsewhere === "told" || (speedElsewhere === "toolCall" && isDrill(tool));
  if (!hasSpeed && unproved.length === 0 && (by === null || !stands)) return { how: "noSpeed", by: null };
  if (stands) return { how: "stopped", by };
  return turns && wanted !== undefined && wanted !== backwards ? { how: "hand", by } : null;
}

/** Data of a motion besides its path: compensated, or in need of a hole. */
export interface GivenForStep {
  readonly isCompensated?: boolean;
  readonly hole?: NeededHole | null;
}

/** Spindle fault and hole needed by a feed move; a reported spindle fault is not repeated. */
export function demands(
  now: Modal,
  known: Known,
  tool: Tool,
  hole: NeededHole | null,
): { readonly spindleFault?: SpindleFault; readonly hole?: NeededHole } {
  const spindleFault = now.spindleChange.told ? null : spindleFaultOf(now, known, tool);
  const needed = hole ?? holeOf(tool);
  return { ...(spindleFault && { spindleFault }), ...(needed && { hole: needed }) };
}
