import { cycleByNumber } from "../../../cycles/index.ts";
import { withInserted } from "../../../nc/edit.ts";
import type { Program } from "../../../nc/program.ts";
import type { Statement } from "../../../nc/statement.ts";
import { valueInProgram } from "../../../program/blocks/cycle-values.ts";
import { countsInches } from "../../../program/edits/program-unit.ts";
import { inProgram, withPrompt } from "./block-prompts.ts";
import type { Repair } from "./repair.ts";
import { promptOf, threadCures, type Overrun } from "./thread-cures.ts";

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
export function threadRepairs(program: Program, index: number, overrun: Overrun): readonly Repair[] {
  const defined = lastCycle(program, index);
  const s = program.blocks[defined]?.statement;
  const cycle = s?.kind === "cycle" ? cycleByNumber(s.cycle) : undefined;
  if (!cycle) return [];
  const { data } = overrun;
  const [open, block] = [defined, ""];
  const runOut = promptOf(cycle, "threadRunOut");
  const cures = threadCures(cycle, overrun, !!(runOut !== undefined && numberOf(s, runOut)), (q, mm) =>
    String(valueInProgram(cycle.params[q], mm, countsInches(program))),
  );
  const repairs = cures.map(({ kind, text, prompts }): Repair => {
    const next = () =>
      Object.entries(prompts).reduce((made, [q, value]) => withPrompt(made, defined, q, value), program);
    return { kind, text, block, open, trial: kind, next };
  });
  const [diameter, pitch] = [
    numberOf(s, promptOf(cycle, "threadDiameter") ?? ""),
    numberOf(s, promptOf(cycle, "threadPitch") ?? ""),
  ];
  const reach = inProgram(program, 2 * Math.abs(data.to - data.end));
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
    // In an undercut a thread needs no run-out.
    const ends = repairs.filter(
      ({ kind }, i) => kind === "endThread" && Object.keys(cures[i]?.prompts ?? {}).length === 1,
    );
    for (const earlier of ends)
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
