import type { Block, Program } from "../../nc/program.ts";
import type { Label } from "../../nc/words.ts";
import { namesIn } from "./contour-names.ts";

/**
 * One text of a run: the main program, or a called one. The blocks of all texts follow one another, so an index
 * identifies a block of any text.
 */
export interface Unit {
  /** Name of its file; null for the program itself. */
  readonly file: string | null;
  readonly program: Program;
  /** Its blocks, `to` excluded. */
  readonly from: number;
  readonly to: number;
  readonly labels: ReadonlyMap<Label, number>;
  /** Labels of contours: a program never runs into them. */
  readonly contours: ReadonlySet<Label>;
  readonly inch: boolean;
  /** Labels that are set again, and where. */
  readonly setTwice: readonly (readonly [label: Label, index: number])[];
}

/** A block with a skip mark while skipping is on. */
export const isSkipped = (block: Block | undefined, skipMarked: boolean): boolean =>
  skipMarked && (block?.skip ?? false);

/** A text as part of a run. */
export function unitFrom(
  program: Program,
  { file, from, skipMarked }: { readonly file: string | null; readonly from: number; readonly skipMarked: boolean },
): Unit {
  const labels = new Map<Label, number>();
  const setTwice: [Label, number][] = [];
  program.blocks.forEach((block, i) => {
    const { statement: s } = block;
    if (s.kind !== "label" || s.label === 0 || isSkipped(block, skipMarked)) return;
    if (labels.has(s.label)) setTwice.push([s.label, from + i]);
    else labels.set(s.label, from + i);
  });
  const begin = program.blocks.find((b) => b.statement.kind === "begin")?.statement;
  const inch = begin?.kind === "begin" && begin.unit === "INCH";
  const to = from + program.blocks.length;
  return { file, program, from, to, labels, contours: namesIn(program.blocks), inch, setTwice };
}
