import type { Cycle } from "../cycles/define.ts";
import type { Param, Params, Values } from "../cycles/params.ts";
import { issue, type Issue } from "../kernel/issue.ts";
import { type KnownParameters, readExpression } from "./expression.ts";
import { triedOffers } from "./tried.ts";

/** What was typed into the prompts of one cycle, by Q number, exactly as typed; a missing key is an empty field. */
export type Draft = Readonly<Record<string, string>>;

/** What one field holds. `null` while nothing usable stands there. */
export interface FieldReading {
  readonly value: number | "auto" | null;
  /** Nothing was typed. An optional field then has the value 0 (NO ENT). */
  readonly empty: boolean;
  /** The Q parameter that stands there alone, to be printed instead of its value. */
  readonly parameter: string | null;
  /** True for a sum: the field shows its value once it is left. */
  readonly computed: boolean;
  readonly issues: readonly Issue[];
}

/** A whole draft read: `values` only when every field can be used. */
export interface DraftReading<P extends Params = Params> {
  readonly values: Values<P> | null;
  readonly partial: Partial<Values<P>>;
  readonly perField: Readonly<Record<string, FieldReading>>;
  readonly issues: readonly Issue[];
}

/** FAUTO as typed: with or without its F, in any case. */
const AUTO = /^f?\s*auto$/i;
/** True for FAUTO as typed. */
export const isAuto = (typed: string) => AUTO.test(typed.trim());

const rounded = (value: number, decimals: number) => {
  const scale = 10 ** decimals;
  const result = Math.round(value * scale) / scale;
  return Number.isFinite(result) ? (result === 0 ? 0 : result) : value;
};

const nearestOf = (choices: readonly number[], value: number) =>
  choices.reduce((best, next) => (Math.abs(next - value) < Math.abs(best - value) ? next : best));

/** What is wrong with a number that the parameter's schema refuses, with the nearest one that it takes. */
function refusal(q: string, param: Param, value: number): Issue {
  if (param.choices) {
    const nearest = nearestOf(param.choices, value);
    return issue("notAChoice", "error", { value, choices: param.choices, nearest }, q);
  }
  const [min, max] = param.range;
  return issue("outOfRange", "error", { value, min, max, nearest: Math.min(max, Math.max(min, value)) }, q);
}

const unusable = (found: Issue, empty = false): FieldReading =>
  ({ value: null, empty, parameter: null, computed: false, issues: [found] });

/** Reads one typed field against its parameter. */
export function readField(q: string, param: Param, typed: string, known: KnownParameters = {}): FieldReading {
  if (param.kind === "feed" && isAuto(typed))
    return { value: "auto", empty: false, parameter: null, computed: false, issues: [] };
  const read = readExpression(typed, known);
  switch (read.kind) {
    case "empty":
      return param.optional
        ? { value: 0, empty: true, parameter: null, computed: false, issues: [] }
        : unusable(issue("missing", "error", {}, q), true);
    case "notANumber": return unusable(issue("notANumber", "error", { text: read.text }, q));
    case "badExpression": return unusable(issue("badExpression", "error", { text: read.text }, q));
    case "unknownParameter": return unusable(issue("unknownParameter", "error", { name: read.name }, q));
    case "number": {
      const value = rounded(read.value, param.decimals);
      if (!param.schema.safeParse(value).success) return unusable(refusal(q, param, value));
      return { value, empty: false, parameter: read.parameter, computed: read.computed, issues: [] };
    }
  }
}

/**
 * The only way from typed text to the values of a cycle. Empty stays missing and never becomes 0, unless the control
 * lets the parameter be left out. A value that is offered in place of a wrong one fits the others, as far as the contour tells.
 */
export function readDraft<P extends Params>(
  cycle: Pick<Cycle<P>, "params"> & Partial<Pick<Cycle<P>, "contour" | "outline">>, draft: Draft, known: KnownParameters = {},
): DraftReading<P> {
  const partial: Record<string, number | "auto"> = {};
  const perField: Record<string, FieldReading> = {};
  const issues: Issue[] = [];
  for (const [q, param] of Object.entries<Param>(cycle.params)) {
    const field = readField(q, param, draft[q] ?? "", known);
    perField[q] = field;
    if (field.value !== null) partial[q] = field.value;
  }
  const { contour, outline } = cycle;
  const judge = contour === "own" && outline
    ? (values: Values<P>) => ({ issues: outline(values, { contour: null, start: null }).issues, moves: 0 }) : null;
  for (const [q, field] of Object.entries(perField)) {
    if (field.issues.length === 0) continue;
    perField[q] = { ...field, issues: triedOffers(cycle.params, partial, field.issues, judge) };
    issues.push(...(perField[q]?.issues ?? []));
  }
  const values = issues.length === 0 ? (partial as Values<P>) : null;
  return { values, partial: partial as Partial<Values<P>>, perField, issues };
}

/** The values of the printed example, as one types them. */
export const exampleDraft = (cycle: Pick<Cycle, "params">): Draft =>
  Object.fromEntries(Object.entries(cycle.params).map(([q, param]) => [q, String(param.example)]));
