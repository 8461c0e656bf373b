import type { Cycle } from "../cycles/define.ts";
import type { Param, Params, Values } from "../cycles/params.ts";
import type { Issue } from "../kernel/issue.ts";
import type { Machine } from "./machine.ts";
import { readField } from "./read-draft.ts";

/** Decimals an inch program keeps beyond those of a millimetre program. */
const INCH_DECIMALS = 1;

const isLength = (p: Param) => p.kind !== "choice" && p.kind !== "angle" && p.kind !== "feed";

/** A number of the program in the unit of the parameter, rounded to what the control keeps of it before it is converted. */
function inMillimetres(machine: Machine, p: Param, n: number): number {
  if (!machine.inch || !(isLength(p) || p.kind === "feed")) return n;
  const kept = Number(n.toFixed(p.decimals + INCH_DECIMALS));
  return p.kind === "feed" ? machine.feedOf(kept) : machine.length(kept);
}

/** Values of a cycle from its definition; null with issues when one is missing or can not be. */
export function cycleValues<P extends Params>(
  machine: Machine, cycle: Cycle<P>, given: ReadonlyMap<string, number | "auto" | null>,
): { readonly values: Values<P> | null; readonly partial: Readonly<Record<string, number | "auto">>; readonly issues: readonly Issue[] } {
  const values: Record<string, number | "auto"> = {};
  const issues: Issue[] = [];
  for (const [q, p] of Object.entries<Param>(cycle.params)) {
    const n = given.get(q) ?? null;
    const typed = n === null ? "" : n === "auto" ? "FAUTO" : plain(inMillimetres(machine, p, n), machine.inch);
    const field = readField(q, machine.inch ? { ...p, decimals: 6 } : p, typed);
    issues.push(...field.issues);
    if (field.value !== null) values[q] = field.value;
  }
  return { values: issues.length === 0 ? (values as Values<P>) : null, partial: values, issues };
}

/** A number without an exponent; what a control keeps is far coarser. */
const plain = (n: number, inch: boolean) => (Math.abs(n) < 1e15 ? n.toFixed(inch ? 9 : 6) : String(n));
