import { useEffect, useMemo } from "react";
import type { Step } from "../../kernel/time/step.ts";
import { blockNumbers, type Program } from "../../nc/program.ts";
import { isOff, operationsOf } from "../../program/edits/operations.ts";
import type { Run } from "../../program/state/run-types.ts";
import { restartComparison } from "../../app/findings/effect/compared.ts";
import { EffectStrip, useEffectCells } from "../../app/findings/effect/EffectStrip.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { useSession } from "../../app/fields/blocks/session.ts";

/** How many tool calls of a text change the tool. */
function toolCalls({ blocks }: Program): number {
  const called = blocks.flatMap(({ statement: s }) =>
    s.kind === "toolCall" && s.tool !== null ? [JSON.stringify(s.tool)] : [],
  );
  return called.filter((tool, i) => tool !== called[i - 1]).length;
}

/** Number of tool changes in a run; a cycle call keeps its tool. */
function toolChangesOf({ steps, operations }: Run): number {
  let changes = 0,
    last: number | null = null;
  for (let i = 0; i < steps.length; i += 1) {
    const { tool, operation } = steps[i] as Step;
    if (tool.T !== last) changes += 1;
    last = tool.T;
    if (operation !== null) i = Math.max(i, operations[operation]?.lastStep ?? i);
  }
  return changes;
}

/**
 * Operations of a program as in its list, where those without a turning cycle or a tool count too; without those that
 * are skipped. More where a call or a loop runs one of them again.
 */
export function operationCount(
  program: Program,
  { operations, steps, stepBlocks, plane }: Pick<Run, "operations" | "steps" | "stepBlocks" | "plane">,
): number {
  const numbers = blockNumbers(program);
  const called = new Set(operations.map(({ block }) => block));
  const cutting = new Set([
    ...stepBlocks.filter((_, i) => steps[i]?.move.kind !== "rapid"),
    ...plane.map(({ index }) => index),
  ]);
  const listed = operationsOf(program).units.filter(
    (own) =>
      !isOff(program, own) &&
      numbers.slice(own.from, own.to).some((block, i) => cutting.has(own.from + i) || called.has(block)),
  );
  return Math.max(operations.length, listed.length);
}

/** The strip of a program: also its operations, tool changes and blocks. */
export function TotalsStrip() {
  const t = useTexts().editor;
  const { shown, number, cells } = useEffectCells();
  const program = useSession((s) => s.reading.program),
    run = shown?.run;
  // Milling moves have neither tool nor operation: those of the text are counted.
  const tools = useMemo(() => run && (run.plane.length > 0 ? toolCalls(program) : toolChangesOf(run)), [program, run]);
  const operations = useMemo(() => run && operationCount(program, run), [program, run]);
  // Another block opens another dialog, which may show the same prompt.
  useEffect(
    () =>
      useSession.subscribe((now, before) => {
        if (now.index !== before.index) restartComparison();
      }),
    [],
  );
  return (
    <EffectStrip
      name={t.total}
      cells={[
        { name: t.operations, value: number(operations, 0) },
        { name: t.toolChanges, value: number(tools, 0) },
        cells.passes,
        cells.time,
        cells.residual,
        { name: t.blocks, value: number(shown?.run.program.blocks, 0), isLeast: true },
      ]}
    />
  );
}
