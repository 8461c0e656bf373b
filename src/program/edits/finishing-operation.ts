import { cycleByNumber } from "../../cycles/index.ts";
import type { Cycle } from "../../cycles/define.ts";
import { hasNoEffect, type SomeValues } from "../../cycles/effect.ts";
import { isPosition } from "../../cycles/completions.ts";
import { withBlock } from "../../nc/edit.ts";
import type { Program } from "../../nc/program.ts";
import { withBlocks } from "../../nc/replace.ts";
import type { Statement, StatementOf } from "../../nc/statement.ts";
import type { CycleParameter } from "../../nc/words.ts";
import {
  blocksOfStatements,
  duplicatedOperation,
  isRefused,
  retooledOperation,
  type Refusal,
} from "./operation-edits.ts";
import { operationsOf, type OperationPart } from "./operations.ts";
import { parametersOf } from "./shared-parameters.ts";

/** Machining operation: roughing and finishing, roughing only, finishing to size. */
const OPERATION = { q: "Q215", both: 0, rough: 1, finish: 2 };
/** Parameters that bind sizes: free ones of the operator's own range. */
const OWN = { first: 20, last: 99 };

/** The cycle of an operation that can be roughed and finished separately; null for any other operation. */
function roughedCycle(program: Program, own: OperationPart | undefined) {
  const [index = -1] = own?.definitions.length === 1 ? own.definitions : [];
  const s = program.blocks[index]?.statement;
  const cycle = s?.kind === "cycle" ? cycleByNumber(s.cycle) : undefined;
  const how = s?.kind === "cycle" ? s.parameters.find(({ q }) => q === OPERATION.q)?.value : undefined;
  if (s?.kind !== "cycle" || !cycle || (how !== OPERATION.both && how !== OPERATION.rough)) return null;
  return { index, cycle, statement: s };
}

export const canBeFinished = (program: Program, own: OperationPart): boolean => roughedCycle(program, own) !== null;

const asNumber = ({ value }: CycleParameter): number | null => (typeof value === "number" ? value : null);

/** A size of the contour: a position, or an element that the contour has. */
function isSize({ params }: Cycle, parameter: CycleParameter, known: SomeValues): boolean {
  const param = params[parameter.q];
  const value = asNumber(parameter);
  if (!param || value === null || hasNoEffect(param, known)) return false;
  return isPosition(param) || ((param.shown === "outline" || param.shown === "element") && value !== 0);
}

/**
 * Repeats an operation as finishing with another tool. Both take their sizes from the same Q parameters, so a changed
 * size changes both; the first one only roughs.
 */
export function finishedOperation(program: Program, unit: number, tool: number): Program | Refusal {
  const found = roughedCycle(program, operationsOf(program).units[unit]);
  if (!found) return program;
  const { index, cycle, statement } = found;
  const { set, read } = parametersOf(program.blocks);
  const taken = (n: number) => set.has(`Q${n}`) || read.has(`Q${n}`);
  const free = Array.from({ length: OWN.last - OWN.first + 1 }, (_, i) => OWN.first + i).filter((n) => !taken(n));
  const known = Object.fromEntries(statement.parameters.map((p) => [p.q, asNumber(p) ?? undefined]));
  const sizes = statement.parameters.filter((p) => isSize(cycle, p, known));
  const bound = new Map(sizes.flatMap(({ q }, i) => (free[i] === undefined ? [] : [[q, `Q${free[i]}`] as const])));
  const made = (how: number): StatementOf<"cycle"> => ({
    ...statement,
    parameters: statement.parameters.map((p): CycleParameter => {
      const name = bound.get(p.q);
      if (p.q === OPERATION.q) return { ...p, value: how };
      return name === undefined ? p : { ...p, value: { parameter: name, negative: false } };
    }),
  });
  const twice = duplicatedOperation(withBlock(program, index, made(OPERATION.rough)), unit);
  if (isRefused(twice)) return twice;
  const second = operationsOf(twice).units[unit + 1]?.definitions[0];
  if (second === undefined) return program;
  const finished = retooledOperation(withBlock(twice, second, made(OPERATION.finish)), unit + 1, tool);
  if (isRefused(finished)) return finished;
  const assignments = sizes.flatMap((p): readonly Statement[] => {
    const [target, value] = [bound.get(p.q), asNumber(p)];
    if (target === undefined || value === null) return [];
    return [{ kind: "assign", fn: null, target, formula: { kind: "value", value } }];
  });
  return withBlocks(finished, [
    ...finished.blocks.slice(0, index),
    ...blocksOfStatements(finished, index, assignments),
    ...finished.blocks.slice(index),
  ]);
}
