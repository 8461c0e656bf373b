import type { Cycle } from "../../cycles/define.ts";
import { neutralOf, saysNothing } from "../../cycles/effect.ts";
import { firstValues } from "../../cycles/first-values.ts";
import type { Param, Params, Values } from "../../cycles/params.ts";
import type { Issue } from "../../kernel/plan/issue.ts";
import type { KnownParameters } from "../values/expression.ts";
import { type Field, type FieldReading, readText } from "../values/field.ts";
import { triedOffers } from "../values/tried.ts";

/** What was typed into the prompts of one cycle, by Q number, exactly as typed; a missing key is an empty field. */
export type Draft = Readonly<Record<string, string>>;

/** A whole draft read: `values` only when every field can be used. */
export interface DraftReading<P extends Params = Params> {
  readonly values: Values<P> | null;
  readonly partial: Partial<Values<P>>;
  readonly perField: Readonly<Record<string, FieldReading>>;
  readonly issues: readonly Issue[];
}

/** The prompt of a parameter. */
export const promptField = (q: string, param: Param): Field => ({ ...param, id: q });

/** What a prompt gives to its cycle: an optional one that is left out (NO ENT) counts as 0. */
const valueOf = (param: Param, { written, value, empty }: FieldReading): number | "auto" | null =>
  written === "auto" ? written : empty && param.optional ? 0 : value;

/**
 * The only way from typed text to the values of a cycle. Empty stays missing and never becomes 0, unless the control
 * lets the parameter be left out, or the others say that it has no effect (decision 0013). A value that is offered in
 * place of a wrong one fits the others, as far as the contour tells.
 */
export function readDraft<P extends Params>(
  cycle: Pick<Cycle<P>, "params"> & Partial<Pick<Cycle<P>, "contour" | "outline">>,
  draft: Draft,
  known: KnownParameters = {},
): DraftReading<P> {
  const partial: Record<string, number | "auto"> = {};
  const perField: Record<string, FieldReading> = {};
  for (const [q, param] of Object.entries<Param>(cycle.params)) {
    const field = readText(promptField(q, param), draft[q] ?? "", known);
    perField[q] = field;
    const value = valueOf(param, field);
    if (value !== null) partial[q] = value;
  }
  for (const [q, param] of Object.entries<Param>(cycle.params)) {
    const field = perField[q];
    if (!field?.issue || !field.empty || !saysNothing(param, partial)) continue;
    perField[q] = { ...field, issue: null };
    partial[q] = neutralOf(param);
  }
  const { contour, outline } = cycle;
  const judge =
    contour === "own" && outline
      ? (values: Values<P>) => ({
          issues: outline(values, { contour: null, start: null }).issues,
          moves: 0,
          passes: null,
        })
      : null;
  const found = Object.values(perField).flatMap((field) => field.issue ?? []);
  const issues = found.map((each) => triedOffers(cycle.params, partial, [each], judge)[0] ?? each);
  const values = issues.length === 0 ? (partial as Values<P>) : null;
  return { values, partial: partial as Partial<Values<P>>, perField, issues };
}

/** The values of the printed example, as one types them. */
export const exampleDraft = (cycle: Pick<Cycle, "params" | "setup">): Draft =>
  Object.fromEntries(Object.entries(firstValues(cycle)).map(([q, value]) => [q, String(value)]));
