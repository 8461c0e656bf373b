import type { Statement, StatementOf } from "../../nc/statement.ts";
import { isFreeElement, type FreeWritten } from "../state/free-contour.ts";
import { programIssue } from "../state/issue.ts";
import type { Machine } from "../state/machine.ts";

type Free = StatementOf<"free">;

/** Blocks allowed between the elements of one contour, without a motion of their own. */
const BETWEEN: ReadonlySet<Statement["kind"]> = new Set(["empty", "comment", "structure", "chamfer"]);
/** Most elements solved together; a control takes no more either. */
const MOST = 200;

interface Collected {
  readonly run: readonly FreeWritten[];
  readonly indices: readonly number[];
}

/** Consecutive elements from a block on, with the blocks between them. */
export function collectFree(machine: Machine, from: number): Collected {
  const [run, indices]: [FreeWritten[], number[]] = [[], []];
  for (let i = from; i < machine.blocks.length && indices.length < MOST; i += 1) {
    if (machine.isSkipped(i)) continue;
    const s = machine.peek(i);
    if (s?.kind === "free") {
      run.push({ s, block: machine.log.numberOf(i) ?? i });
      if (isFreeElement(s)) indices.push(i);
    } else if (!s || !(BETWEEN.has(s.kind) || (s.kind === "path" && s.path === "RND"))) break;
  }
  return { run: withPole(machine, from, run), indices };
}

/** Puts FPOL before the elements that refer to it. */
function withPole(machine: Machine, from: number, run: readonly FreeWritten[]): readonly FreeWritten[] {
  for (let i = from - 1; i >= 0; i -= 1) {
    const s = machine.peek(i);
    if (s?.kind === "free" && s.form === "FPOL") return [{ s, block: machine.log.numberOf(i) ?? i }, ...run];
    if (!s || (s.kind !== "free" && !BETWEEN.has(s.kind))) return run;
  }
  return run;
}

/** Reports an element that cannot be solved. */
export function sayUnsolved(machine: Machine, s: Free, index: number): void {
  machine.log.report(programIssue("freeUnsolved", "warning", { form: s.form }), index);
  machine.log.leaveUnproved(s.form, index);
}

/** Reports that another solution is possible from here on. */
export function sayChosen(machine: Machine, index: number): void {
  machine.log.report(programIssue("freeChosen", "warning", {}), index);
  machine.log.leaveUnproved("FSELECT", index);
}
