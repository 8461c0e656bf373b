import { cycleByNumber } from "../../../cycles/index.ts";
import type { Param } from "../../../cycles/params.ts";
import type { Issue } from "../../../kernel/plan/issue.ts";
import { withInserted } from "../../../nc/edit.ts";
import type { Program } from "../../../nc/program.ts";
import type { Statement } from "../../../nc/statement.ts";
import { valueInProgram } from "../../../program/blocks/cycle-values.ts";
import { countsInches } from "../../../program/edits/program-unit.ts";
import { inProgram, withPrompt } from "./block-prompts.ts";
import type { Repair } from "./repair.ts";

type Overrun = Extract<Issue, { code: "threadOverruns" }>;

/** How much earlier a thread is ended, in overruns. */
const EARLIER = [0.5, 1, 1.5, 2];
/** Decimals of a new end, mm. */
const TENTH = 10;

const lastCycle = ({ blocks }: Program, index: number) =>
  blocks.slice(0, index + 1).findLastIndex(({ statement: s }) => s.kind === "cycle");

const numberOf = (s: Statement | undefined, q: string): number | null => {
  const value = s?.kind === "cycle" ? s.parameters.find((p) => p.q === q)?.value : null;
  return typeof value === "number" ? value : null;
};

/** Index of the face behind a cylinder of this diameter where the thread ends, in the contour of a label; null without one. */
function faceBehind({ blocks }: Program, diameter: number, isThere: (z: number) => boolean): number | null {
  let [x, label] = [NaN, false];
  for (const [i, { statement: s }] of blocks.entries()) {
    if (s.kind === "label") label = s.label !== 0;
    if (!label || s.kind !== "path") continue;
    const at = (axis: string) => s.words.axes.find((w) => w.axis === axis && !w.incremental)?.value;
    const [nextX, z, after] = [at("X"), at("Z"), blocks[i + 1]?.statement];
    if (typeof nextX === "number") x = nextX;
    const isFace = after?.kind === "path" && after.words.axes.length === 1 && after.words.axes[0]?.axis === "X";
    if (
      nextX === undefined &&
      typeof z === "number" &&
      isFace &&
      Math.abs(x - diameter) < 0.05 * diameter &&
      isThere(z)
    )
      return i + 1;
  }
  return null;
}

/**
 * Repairs for a thread that overruns into the part, to be tried: a run-out, an earlier end, an undercut of DIN 76 in the
 * corner of its contour.
 */
export function threadRepairs(program: Program, index: number, { data }: Overrun): readonly Repair[] {
  const defined = lastCycle(program, index);
  const s = program.blocks[defined]?.statement;
  const cycle = s?.kind === "cycle" ? cycleByNumber(s.cycle) : undefined;
  if (!cycle) return [];
  const named = (text: Param["text"]) => Object.keys(cycle.params).find((q) => cycle.params[q]?.text === text);
  const [end, runOut] = [named(data.axis === "Z" ? "endZ" : "threadEndDiameter"), named("threadRunOut")];
  const way = Math.sign(data.to - data.end);
  const overrun = Math.abs(data.to - data.end);
  const asTyped = (q: string, mm: number) => String(valueInProgram(cycle.params[q], mm, countsInches(program)));
  const block = "";
  const repairs: Repair[] = [];
  const withRunOut = (made: Program) =>
    runOut === undefined ? made : withPrompt(made, defined, runOut, asTyped(runOut, overrun));
  const open = defined;
  if (runOut !== undefined && !numberOf(s, runOut))
    repairs.push({
      kind: "runOut",
      text: `${runOut} ${asTyped(runOut, overrun)}`,
      block,
      open,
      trial: "runOut",
      next: () => withRunOut(program),
    });
  const earlierEnds =
    end === undefined
      ? []
      : EARLIER.map((share) => {
          const earlier = asTyped(end, Math.round((data.end - way * share * overrun) * TENTH) / TENTH);
          return { text: `${data.axis}${earlier}`, next: () => withPrompt(program, defined, end, earlier) };
        });
  for (const adapt of [(made: Program) => made, withRunOut])
    for (const { text, next } of earlierEnds)
      repairs.push({ kind: "endThread", text, block, open, trial: "endThread", next: () => adapt(next()) });
  const [diameter, pitch] = [numberOf(s, named("threadDiameter") ?? ""), numberOf(s, named("threadPitch") ?? "")];
  const reach = inProgram(program, 2 * overrun);
  const from = inProgram(program, data.end);
  const face =
    data.axis === "Z" && diameter !== null && pitch !== null
      ? faceBehind(program, diameter, (z) => Math.abs(z - from) <= reach)
      : null;
  if (face !== null && pitch !== null) {
    const relief: Statement = { kind: "undercut", form: "THREAD", words: [{ name: "PITCH", value: pitch }] };
    repairs.push({
      kind: "relief",
      text: "",
      block,
      open: face,
      trial: "relief",
      next: () => withInserted(program, face, relief),
    });
    for (const earlier of earlierEnds)
      repairs.push({
        kind: "relief",
        text: earlier.text,
        block,
        open: face,
        trial: "relief",
        next: () => withInserted(earlier.next(), face, relief),
      });
  }
  return repairs;
}
