import { cuttingCycles } from "../../cycles/index.ts";
import { never } from "../../kernel/never.ts";
import type { FieldFacts, Unseen } from "../../nc/blocks/define.ts";
import { klartext } from "../../nc/blocks/klartext.ts";
import type { BlockKind } from "../../nc/blocks/names.ts";
import { exampleJob } from "../../program/job/job.ts";
import { printedText } from "../../app/document/printed.ts";

/** Prefix of the block that a sample is about. */
const MARK = "> ";

/** A slender insert, so that undercuts and recesses come out as programmed. */
const SLENDER = "TOOL CALL 4";

/** An element of a contour that a cycle cuts: an undercut or a recess. */
function inContour(element: string): readonly string[] {
  const cycle = cuttingCycles.find(({ contour }) => contour === "free") ?? never("no cycle of a free contour");
  const lines = printedText(exampleJob(cycle))
    .split(/\r?\n/)
    .map((line) => line.replace(/^\d+\s+/, ""))
    .filter((line) => line !== "");
  const from = lines.findLastIndex((line) => /^LBL [^0]/.test(line)),
    to = lines.findIndex((line, i) => i > from && /^LBL 0/.test(line));
  return lines
    .toSpliced(from + 1, to - from - 1, "L X+20 Z+0", "L Z-30", element, "L X+44", "L Z-45")
    .map((line) => line.replace(/^TOOL CALL \d+/, SLENDER));
}

/** A small program that uses a block and one of its words; null if there is none of this kind. */
export interface BlockSample {
  readonly text: string;
  /** Its line, from 1. */
  readonly line: number;
}

const named = new Map(klartext.named);

export function blockSample(kind: BlockKind, word: string | null): BlockSample | null {
  const { sample, samples } = named.get(kind) ?? {};
  const found = (word === null ? undefined : samples?.[word]) ?? sample;
  if (found === undefined) return null;
  const lines = typeof found === "string" ? inContour(found) : found.flatMap((line) => line.split("\n"));
  return {
    text: `${lines.map((line) => line.replace(MARK, "")).join("\n")}\n`,
    line: lines.findIndex((line) => line.startsWith(MARK)) + 1,
  };
}

/** Why a word of a kind of block has no live picture. */
export const whyUnseen = (kind: BlockKind, field: FieldFacts): Unseen =>
  named.get(kind)?.noPicture ?? field.noPicture ?? "same";
