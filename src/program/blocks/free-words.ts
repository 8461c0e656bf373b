import type { Statement, StatementOf } from "../../nc/statement.ts";
import { isFreeElement, type FreeWritten } from "../state/free-contour.ts";
import { programIssue } from "../state/issue.ts";
import type { Machine } from "../state/machine.ts";

type Free = StatementOf<"free">;

/** Blocks that stand between the elements of one contour and give none. */
const BETWEEN: ReadonlySet<Statement["kind"]> = new Set(["empty", "comment", "structure", "chamfer"]);
/** Elements that are solved at once; a control does not take more either. */
const MOST = 200;

interface Collected {
  readonly run: readonly FreeWritten[];
  readonly indices: readonly number[];
}

/** The elements that follow one another from a block on, with what is said between them. */
export function collectFree(machine: Machine, from: number): Collected {
  const [run, indices]: [FreeWritten[], number[]] = [[], []];
  for (let i = from; i < machine.blocks.length && indices.length < MOST; i += 1) {
    if (machine.isSkipped(i)) continue;
    const s = machine.foresee(i);
    if (s?.kind === "free") {
      run.push({ s, block: machine.log.numberOf(i) ?? i });
      if (isFreeElement(s)) indices.push(i);
    } else if (!s || !(BETWEEN.has(s.kind) || (s.kind === "path" && s.path === "RND"))) break;
  }
  return { run: withPole(machine, from, run), indices };
}

/** FPOL stands in front of the elements that count from it. */
function withPole(machine: Machine, from: number, run: readonly FreeWritten[]): readonly FreeWritten[] {
  for (let i = from - 1; i >= 0; i -= 1) {
    const s = machine.foresee(i);
    if (s?.kind === "free" && s.form === "FPOL") return [{ s, block: machine.log.numberOf(i) ?? i }, ...run];
    if (!s || (s.kind !== "free" && !BETWEEN.has(s.kind))) return run;
  }
  return run;
}

/** Says of an element that it can not be solved. */
export function sayUnsolved(machine: Machine, s: Free, index: number): void {
  machine.log.say(programIssue("freeUnsolved", "warning", { form: s.form }), index);
  machine.log.leaveUnproved(s.form, index);
}

/** Says that another contour fits too from here on. */
export function sayChosen(machine: Machine, index: number): void {
  machine.log.say(programIssue("freeChosen", "warning", {}), index);
  machine.log.leaveUnproved("FSELECT", index);
}
