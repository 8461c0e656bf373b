import { noWords } from "../nc/words.ts";
import { cycleByNumber } from "../cycles/index.ts";
import { parse } from "../nc/parse.ts";
import { programText } from "../nc/print.ts";
import { LAYOUTS } from "../nc/style.ts";
import { rowsFrom } from "../program/job/contour-of-text.ts";
import { exampleJob, UNSET, type Job } from "../program/job/job.ts";
import { nameOnControl } from "../program/job/print-job.ts";
import { shippedList, type ToolList } from "../program/tools/tool-list.ts";
import { cellOf } from "../program/tools/tool-entry.ts";
import { shownId, type Task } from "./task.ts";

/** What opens when a task starts. */
export type TaskStart =
  | { readonly kind: "job"; readonly job: Job }
  | { readonly kind: "program"; readonly name: string; readonly text: string };

/** Lines of a program as one text. */
export const programOfLines = (lines: readonly string[]): string => lines.map((line) => `${line}\n`).join("");

/** The texts of a program's blocks, each with all its lines and their line ends. */
export const blocksOfLines = (lines: readonly string[]): readonly string[] =>
  parse(programOfLines(lines)).blocks.map(({ raw }) => raw);

/** The program name of a task on the control. */
const nameOf = (task: Task): string => nameOnControl(shownId(task).toUpperCase());

/** The name that a program states for itself. */
const ownName = ([first = ""]: readonly string[]): string | undefined => /\bBEGIN\s+PGM\s+(\S+)/.exec(first)?.[1];

/** A program with nothing but the blank of the target part, if there is one, that runs to its end. */
function emptyText(task: Task): string {
  const name = nameOf(task);
  const blank = task.part ? parse(programOfLines(task.part.blank)).blocks.map(({ statement }) => statement) : [];
  return programText(
    [
      { kind: "begin", name, unit: "MM" },
      ...blank,
      { kind: "mode", mode: "TURN", kinematics: null },
      {
        kind: "functions",
        words: { ...noWords, functions: [30] },
      },
      { kind: "end", name, unit: "MM" },
    ],
    LAYOUTS.tnc7,
  );
}

/**
 * What opens when a task starts: the prompts of its cycle with only the given values, its program, or an empty one. An
 * unknown cycle also starts with an empty program.
 */
export function startOfTask(task: Task): TaskStart {
  const { start } = task;
  const program = (text: string, name = nameOf(task)): TaskStart => ({ kind: "program", name: `${name}.h`, text });
  // A program keeps its own name: the name of the task might reveal its fault.
  if ("program" in start) return program(programOfLines(start.program), ownName(start.program));
  const cycle = "cycle" in start ? cycleByNumber(start.cycle) : undefined;
  if (!("cycle" in start) || !cycle) return program(emptyText(task));
  const { values, blank, tool, at, contour } = start;
  return {
    kind: "job",
    job: {
      ...exampleJob(cycle),
      ...UNSET,
      name: nameOf(task),
      drafts: { [cycle.number]: values },
      contour: contour ? rowsFrom(parse(programOfLines(contour)), 0) : [],
      ...(tool !== undefined && { tool }),
      ...(blank && { blank }),
      ...(at && { start: at }),
    },
  };
}

/**
 * The shipped tools that a task allows, all of them where it names none: a task does not depend on the device's tool
 * table.
 */
export function toolsOfTask({ rules: { tools } }: Task): ToolList {
  return tools ? shippedList.filter((entry) => tools.includes(Number(cellOf(entry, "T")))) : shippedList;
}
