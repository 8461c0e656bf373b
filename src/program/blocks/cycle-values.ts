import type { Cycle } from "../../cycles/define.ts";
import type { Param, Params, Values } from "../../cycles/params.ts";
import { issue, type Issue } from "../../kernel/plan/issue.ts";
import { checkNumber, roundedTo } from "../values/field.ts";
import { INCH, inchFeedUnit, roundedInch } from "../../kernel/units.ts";
import type { Machine } from "../state/machine.ts";

/** Decimals an inch program keeps beyond those of a millimetre program. */
const INCH_DECIMALS = 1;
/** Decimals of a value that was converted from inches, mm. */
const CONVERTED_DECIMALS = 6;

const NO_LENGTH: ReadonlySet<string> = new Set([
  "choice",
  "angle",
  "feed",
  "count",
  "factor",
  "percent",
  "revolutions",
]);
const isLength = (p: { readonly kind: string }) => !NO_LENGTH.has(p.kind);
const hasInches = (p: { readonly kind: string }) => isLength(p) || p.kind === "feed";

/** Decimals of a parameter in an inch program. */
export const decimalsInInches = (p: { readonly kind: string; readonly decimals: number }): number =>
  hasInches(p) ? p.decimals + INCH_DECIMALS : p.decimals;

/** The unit of a parameter in an inch program, mm. */
const inchUnit = (p: { readonly kind: string }, perRevolution: boolean): number =>
  p.kind === "feed" ? inchFeedUnit(perRevolution) : INCH;

/** A parameter value in mm as the program writes it, in inches where it counts in inches. */
export function valueInProgram(
  p: { readonly kind: string } | undefined,
  mm: number,
  inches: boolean,
  perRevolution = true,
): number {
  if (!inches || !p || !hasInches(p)) return mm;
  return roundedInch(mm / inchUnit(p, perRevolution));
}

/** A number of an inch program in the unit of the parameter, rounded to the control's resolution before conversion. */
export function valueFromInches(p: Param, n: number, perRevolution: boolean): number {
  if (!hasInches(p)) return roundedTo(n, CONVERTED_DECIMALS);
  return roundedTo(roundedTo(n, decimalsInInches(p)) * inchUnit(p, perRevolution), CONVERTED_DECIMALS);
}

const inMillimetres = ({ now }: Machine, p: Param, n: number): number =>
  now.inch ? valueFromInches(p, n, now.perRevolution) : roundedTo(n, p.decimals);

/** One value of a definition, or its issue; an omitted optional value counts as 0. */
function valueOf(machine: Machine, q: string, p: Param, given: number | "auto" | null): number | "auto" | Issue {
  if (given === null) return p.optional ? 0 : issue("missing", "error", {}, q);
  if (given === "auto") return p.kind === "feed" ? given : issue("notANumber", "error", { text: "FAUTO" }, q);
  const value = inMillimetres(machine, p, given);
  return checkNumber({ ...p, id: q }, value) ?? value;
}

/** Values of a cycle from its definition; null with issues when one is missing or invalid. */
export function cycleValues<P extends Params>(
  machine: Machine,
  cycle: Cycle<P>,
  given: ReadonlyMap<string, number | "auto" | null>,
): {
  readonly values: Values<P> | null;
  readonly partial: Readonly<Record<string, number | "auto">>;
  readonly issues: readonly Issue[];
} {
  const values: Record<string, number | "auto"> = {};
  const issues: Issue[] = [];
  for (const [q, p] of Object.entries<Param>(cycle.params)) {
    const value = valueOf(machine, q, p, given.get(q) ?? null);
    if (typeof value === "object") issues.push(value);
    else values[q] = value;
  }
  return { values: issues.length === 0 ? (values as Values<P>) : null, partial: values, issues };
}
