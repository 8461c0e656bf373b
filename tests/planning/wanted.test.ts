import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, test } from "vitest";
import { readPart } from "../../src/planning/part/part-file.ts";
import type { StepReason } from "../../src/planning/working-plan.ts";
import { planOf, requestOf, unprepared } from "./plan-laws.ts";

/** A part with what its plan must contain. A step reads "kind type-of-tool cycle"; parts of it are enough. */
interface Wanted {
  readonly says: string;
  readonly part: unknown;
  /** Steps in this order; others may stand between them. */
  readonly inOrder: readonly string[];
  /** Steps that it must not have. */
  readonly never?: readonly string[];
  /** Words of the program. */
  readonly program?: readonly string[];
  /** Reasons of any step. */
  readonly why?: readonly Partial<StepReason>[];
  /** Rules of the shop under which the same part is planned in another order. */
  readonly otherwise?: { readonly rules: object; readonly inOrder: readonly string[] };
}

const FOLDER = join("tests", "planning", "wanted");
const wanted = readdirSync(FOLDER).map(
  (name) => [name.replace(".json", ""), JSON.parse(readFileSync(join(FOLDER, name), "utf8")) as Wanted] as const,
);

function planned(part: unknown) {
  const { part: file, problems } = readPart(JSON.stringify(part));
  const request = file && requestOf(file);
  if (!request) throw new Error(JSON.stringify(problems));
  const plan = planOf(request);
  const steps = plan.steps.map(
    ({ tried: { action } }) => `${action.kind} ${action.tool.TYPE} ${action.cycle ?? "path"}`,
  );
  return { plan, steps };
}

/** Those of some steps that stand in a plan in their order. */
function found(steps: readonly string[], inOrder: readonly string[]): readonly string[] {
  let at = -1;
  return inOrder.filter((words) => {
    const next = steps.findIndex((step, i) => i > at && step.includes(words));
    if (next < 0) return false;
    at = next;
    return true;
  });
}

test.each(wanted)("%s", (_, { part, inOrder, never = [], program = [], why = [], otherwise }) => {
  const { plan, steps } = planned(part);
  expect([plan.judged.verdict, plan.isComplete]).toEqual(["proved", true]);
  expect(unprepared(plan)).toEqual([]);
  expect(found(steps, inOrder), steps.join(", ")).toEqual(inOrder);
  for (const words of never) expect(steps.join(", ")).not.toContain(words);
  for (const words of program) expect(plan.text).toContain(words);
  const reasons = plan.steps.flatMap((step) => step.why);
  for (const reason of why) expect(reasons).toContainEqual(expect.objectContaining(reason));
  if (!otherwise) return;
  const other = planned({ ...(part as object), rules: otherwise.rules }).steps;
  expect(found(other, otherwise.inOrder), other.join(", ")).toEqual(otherwise.inOrder);
});
