import { isDrill } from "../../kernel/cutter/drill.ts";
import { tipDirection } from "../../kernel/cutter/insert.ts";
import type { PlanContext } from "../../kernel/plan/plan.ts";
import { SAME } from "../../kernel/tolerance.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import type { Machine } from "../state/machine.ts";

/** FUNCTION TURNDATA BLANK: from here on the run tracks the stock. */
export function traceBlank(machine: Machine, rings: readonly Ring[]): void {
  const {
    shop,
    log,
    now: { clamping },
  } = machine;
  const blank = shop.tracing?.(rings, clamping?.made ?? null);
  machine.change({ traced: blank ? { blank, next: log.steps.length } : null });
}

/**
 * Stock at a cycle call; null after earlier cuts, which only the simulation knows. A traced blank is updated by all
 * steps so far.
 */
export function stockAtCall(machine: Machine): readonly Ring[] | null {
  const {
    run: { traced },
    now: { blank, blankSince },
    log: { steps, operations },
  } = machine;
  if (traced) {
    const cut = traced.blank.cut(steps.slice(traced.next));
    machine.change({ traced: { blank: cut, next: steps.length } });
    return cut.stock;
  }
  const isUncut =
    operations.length === blankSince.operations && !steps.slice(blankSince.steps).some((s) => isDrill(s.tool));
  return isUncut && blank.length > 0 ? blank : null;
}

/**
 * Part of the blank not bored yet: below the lowest Z of a drill or of a cut on the axis. Null where the stock is
 * unknown, as after effects that are not simulated.
 */
export function solidAtCall(machine: Machine): PlanContext["solid"] {
  const {
    run: { traced },
    now: { blank, blankSince, bored: noted },
    log: { steps, operations, unproved },
  } = machine;
  if (traced) return { rings: stockAtCall(machine) ?? [], below: Infinity, isBored: false };
  if (blank.length === 0 || unproved.length > 0) return null;
  const known = noted?.since === blankSince ? noted : { ...blankSince, below: Infinity, isBored: false };
  let { below, isBored } = known;
  for (const { tool, move, operation } of steps.slice(known.steps)) {
    if (move.kind === "rapid") continue;
    if (isDrill(tool) || move.to.r <= SAME) below = Math.min(below, move.to.z);
    isBored ||= operation === null && tipDirection(tool.TO).v > 0;
  }
  isBored ||= operations.slice(known.operations).some(({ plan }) => plan.openSide.r < 0);
  machine.set({ bored: { since: blankSince, steps: steps.length, operations: operations.length, below, isBored } });
  return { rings: blank, below, isBored };
}
