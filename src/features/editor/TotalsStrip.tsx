import { useEffect, type ReactNode } from "react";
import { formatFixed } from "../../i18n/number.ts";
import type { Step } from "../../kernel/time/step.ts";
import { blockNumbers, type Program } from "../../nc/program.ts";
import { isOff, operationsOf } from "../../program/edits/operations.ts";
import type { Run } from "../../program/state/run-types.ts";
import { restartComparison, followComparing } from "../../app/findings/effect/compared.ts";
import { areaDecimals, type ComparedNumber } from "../../app/findings/effect/changes.ts";
import { effectNow } from "../../app/findings/effect/effect.ts";
import { PinButton } from "../../app/findings/effect/Pinned.tsx";
import { durationText } from "../../app/base/clock-text.ts";
import { TimeName } from "../../app/findings/effect/TimeName.tsx";
import { FaultsChange, useChanges } from "../../app/findings/effect/EffectChanges.tsx";
import { Checking, useChecking } from "../../app/calculation/Checking.tsx";
import { useOutcome } from "../../app/calculation/outcome.ts";
import { StripStatus } from "../../app/findings/StripStatus.tsx";
import { useVerdict } from "../../app/findings/use-findings.ts";
import { VerdictText } from "../../app/findings/VerdictText.tsx";
import { useLengths } from "../../app/calculation/lengths.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { useSession } from "../../app/fields/blocks/session.ts";
import { SpokenEffect } from "../../app/findings/effect/SpokenEffect.tsx";

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
      numbers.some((block, i) => i >= own.from && i < own.to && (cutting.has(i) || called.has(block))),
  );
  return Math.max(operations.length, listed.length);
}

/** Totals of the program: operations, passes, tool changes, time, residual material, and the verdict. */
export function TotalsStrip() {
  const t = useTexts();
  const lengths = useLengths(),
    { language } = lengths;
  const shown = useOutcome((s) => s.pictured);
  const proved = useOutcome((s) => s.shown);
  const dimmed = useOutcome((s) => s.dimmed);
  const checking = useChecking();
  const verdict = useVerdict();
  const effect = shown && effectNow(shown, proved);
  const words = t.page.effect;
  const number = (value: number | null | undefined, decimals: number) =>
    value === undefined || value === null ? words.unknown : formatFixed(language, value, decimals);
  const program = useSession((s) => s.reading.program),
    run = shown?.run;
  // Milling moves have neither tool nor operation: those of the text are counted.
  const tools = run && (run.plane.length > 0 ? toolCalls(program) : toolChangesOf(run));
  const operations = run && operationCount(program, run);
  useEffect(() => {
    const stop = followComparing();
    // Another block opens another dialog, which may show the same prompt.
    const stopBlocks = useSession.subscribe((now, before) => {
      if (now.index !== before.index) restartComparison();
    });
    return () => {
      stopBlocks();
      stop();
    };
  }, []);
  const { changed } = useChanges();
  const cell = (name: ReactNode, value: ReactNode, unit = "", compared: ComparedNumber | null = null) => (
    <div className={`effect-cell${compared === "residual" ? " stays" : ""}`}>
      <dt>{name}</dt>
      <dd {...(compared && changed(compared))}>
        <span className="number">{value}</span>
        {unit && <span className="soft small"> {unit}</span>}
      </dd>
    </div>
  );
  return (
    <section className="effect" aria-label={t.editor.total} aria-busy={checking.now} data-checking={checking.seen}>
      <dl className={dimmed ? "dimmed" : ""}>
        {cell(t.editor.operations, number(operations, 0))}
        {cell(t.editor.toolChanges, number(tools, 0))}
        {cell(words.passes, number(effect?.passes, 0), "", "passes")}
        {cell(
          <TimeName name={words.time} />,
          effect ? durationText(words.duration, language, effect.seconds) : words.unknown,
          "",
          "time",
        )}
        {cell(
          words.residual,
          effect?.residual
            ? lengths.fixedArea(effect.residual, areaDecimals(effect.residual))
            : effect?.residual === 0
              ? words.none
              : words.unknown,
          effect?.residual ? lengths.words("mm²") : "",
          "residual",
        )}
        {cell(t.editor.blocks, number(shown?.run.program.blocks, 0))}
        <div className="effect-cell proof">
          <dt>
            {t.findings.verdict.title} <FaultsChange />
          </dt>
          <dd>
            <VerdictText verdict={verdict} reasons={verdict.state === "faults" ? 0 : 1} />
            {checking.seen && <Checking />}
          </dd>
        </div>
      </dl>
      <PinButton />
      <StripStatus />
      <SpokenEffect />
    </section>
  );
}
