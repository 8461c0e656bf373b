import type { Issue } from "../../../kernel/plan/issue.ts";
import type { Program } from "../../../nc/program.ts";
import type { StatementOf } from "../../../nc/statement.ts";
import { readText, type FieldReading } from "../../../program/values/field.ts";
import { OWN_DECIMALS, ownField, type OwnCycle, type OwnParameter } from "../../../program/edits/own-cycle.ts";
import type { Draft } from "../../../program/job/read-draft.ts";
import { parameterAsTyped } from "../../../program/values/typed-value.ts";
import { parametersBefore, perRevolutionBefore } from "./block-context.ts";

/** A parameter of a block, with a description or only in the text. */
export interface OwnPrompt extends OwnParameter {
  readonly described: boolean;
}

/** A block of an own cycle, with the text being typed. */
export interface OwnBlock {
  readonly own: OwnCycle;
  readonly parameters: readonly OwnPrompt[];
  readonly draft: Draft;
  readonly readings: Readonly<Record<string, FieldReading>>;
  readonly issues: readonly Issue[];
  /** Its feeds are per revolution. */
  readonly perRevolution: boolean;
}

/** Parameters in the text that the description does not have; any value is accepted. */
const undescribed = (s: StatementOf<"cycle">, own: OwnCycle): readonly OwnPrompt[] =>
  s.parameters
    .filter(
      ({ q }, i) => !own.parameters.some((p) => p.q === q) && s.parameters.findIndex((each) => each.q === q) === i,
    )
    .map(({ q, label, value }) => ({
      q,
      prompt: (label ?? "").trim(),
      kind: value === "auto" || value === "max" ? "feed" : "number",
      range: [-Infinity, Infinity],
      bounded: false,
      choices: null,
      first: 0,
      described: false,
    }));

/** The prompts of a block whose cycle is described; null for any other block. */
export function readingOfOwn(
  program: Program,
  index: number,
  typed: Draft,
  cycles: ReadonlyMap<number, OwnCycle>,
): OwnBlock | null {
  const s = program.blocks[index]?.statement;
  const own = s?.kind === "cycle" ? cycles.get(s.cycle) : undefined;
  if (!own || s?.kind !== "cycle") return null;
  const parameters = [...own.parameters.map((p): OwnPrompt => ({ ...p, described: true })), ...undescribed(s, own)];
  const draft: Draft = { ...Object.fromEntries(s.parameters.map((p) => [p.q, parameterAsTyped(p.value)])), ...typed };
  const known = parametersBefore(program, index);
  const readings = Object.fromEntries(
    parameters.map((p) => [p.q, readText({ ...ownField(p), decimals: OWN_DECIMALS }, draft[p.q] ?? "", known)]),
  );
  return {
    own,
    parameters,
    draft,
    readings,
    issues: Object.values(readings).flatMap(({ issue }) => issue ?? []),
    perRevolution: perRevolutionBefore(program, index),
  };
}
