import type { Cycle } from "../../cycles/define.ts";
import { neutralValueOf, hasNoEffect } from "../../cycles/effect.ts";
import { firstValues } from "../../cycles/first-values.ts";
import type { Param, Params, Values } from "../../cycles/params.ts";
import type { Issue } from "../../kernel/plan/issue.ts";
import type { KnownParameters } from "../values/expression.ts";
import { valueFromInches } from "../blocks/cycle-values.ts";
import { anyNumber, checkNumber, type Field, type FieldReading, readText, rejectedReading } from "../values/field.ts";

/** Typed text of the prompts of one cycle, by Q number; a missing key is an empty field. */
export type Draft = Readonly<Record<string, string>>;

/** Reading of a draft: `values` only when every field is valid. */
export interface DraftReading<P extends Params = Params> {
  readonly values: Values<P> | null;
  readonly partial: Partial<Values<P>>;
  readonly perField: Readonly<Record<string, FieldReading>>;
  readonly issues: readonly Issue[];
}

const prompts = new WeakMap<Param, Field>();

/** The prompt of a parameter. */
export function promptField(q: string, param: Param): Field {
  const known = prompts.get(param);
  if (known?.id === q) return known;
  const field: Field = { ...param, id: q };
  prompts.set(param, field);
  return field;
}

/** How a draft in inches counts its feeds. */
export interface DraftInches {
  readonly perRevolution: boolean;
}

/** Reading of a prompt, in mm. */
function readPrompt(
  q: string,
  param: Param,
  text: string,
  known: KnownParameters,
  inches: DraftInches | null,
): FieldReading {
  const field = promptField(q, param);
  if (inches === null) return readText(field, text, known);
  const read = readText({ ...field, range: anyNumber.range, decimals: null }, text, known);
  if (read.value === null) return read;
  const value = valueFromInches(param, read.value, inches.perRevolution);
  const found = checkNumber(field, value);
  return found ? rejectedReading(found) : { ...read, value };
}

/** Value of a prompt for its cycle: an omitted optional one (NO ENT) counts as 0. */
const valueOf = (param: Param, { written, value, empty }: FieldReading): number | "auto" | null =>
  written === "auto" ? written : empty && param.optional ? 0 : value;

/**
 * The only conversion from typed text to the values of a cycle. Empty stays missing and never becomes 0, unless the
 * parameter is optional or has no effect with the other values (decision 0013). Offered values are not tried yet
 * (`triedDraft`).
 */
export function readDraft<P extends Params>(
  cycle: Pick<Cycle<P>, "params">,
  draft: Draft,
  known: KnownParameters = {},
  inches: DraftInches | null = null,
): DraftReading<P> {
  const partial: Record<string, number | "auto"> = {};
  const perField: Record<string, FieldReading> = {};
  for (const [q, param] of Object.entries<Param>(cycle.params)) {
    const field = readPrompt(q, param, draft[q] ?? "", known, inches);
    perField[q] = field;
    const value = valueOf(param, field);
    if (value !== null) partial[q] = value;
  }
  for (const [q, param] of Object.entries<Param>(cycle.params)) {
    const field = perField[q];
    if (!field?.issue || !field.empty || !hasNoEffect(param, partial)) continue;
    perField[q] = { ...field, issue: null };
    partial[q] = neutralValueOf(param);
  }
  const issues = Object.values(perField).flatMap((field) => field.issue ?? []);
  const values = issues.length === 0 ? (partial as Values<P>) : null;
  return { values, partial: partial as Partial<Values<P>>, perField, issues };
}

/** Values of the printed example, as typed. */
export const exampleDraft = (cycle: Pick<Cycle, "params" | "setup">): Draft =>
  Object.fromEntries(Object.entries(firstValues(cycle)).map(([q, value]) => [q, String(value)]));
