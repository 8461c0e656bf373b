import { withBlock } from "../../nc/edit.ts";
import type { Program } from "../../nc/program.ts";
import type { Statement } from "../../nc/statement.ts";
import { isRefused, type Refusal } from "../../program/edits/operation-edits.ts";

/** What a change does; each kind is a file of `kinds/` and a line of its table; `both`: two changes at once. */
export type ChangeKind =
  | "noCut"
  | "fewerTools"
  | "fewerChanges"
  | "restOperation"
  | "otherTool"
  | "otherCycle"
  | "otherChoice"
  | "infeed"
  | "stiffness"
  | "start"
  | "oneCall"
  | "cuttingSpeed"
  | "feed"
  | "both";

/** The subject of a change, for its words. */
export interface ChangeSubject {
  readonly kind: ChangeKind;
  /** The operations it is about, by index in the program before; the first one is changed. */
  readonly units: readonly number[];
  /** The tool that takes the work, and the one that it takes it from. */
  readonly tool?: number;
  readonly instead?: number;
  /** The tools that take the work of several operations. */
  readonly tools?: readonly number[];
  /** The new cycle. */
  readonly cycle?: number;
  /** The changes that are made at once. */
  readonly parts?: readonly ChangeSubject[];
  /** A changed value in the unit of the program. */
  readonly value?: ChangedValue;
}

/** A changed parameter: before and after, and the limit that it keeps. Of several operations: the least and the most. */
export interface ChangedValue {
  readonly at: string;
  readonly from: number;
  readonly to: number;
  readonly most?: number;
  readonly upTo?: { readonly from: number; readonly to: number };
}

/** A block with another statement. */
export interface Replacement {
  readonly index: number;
  readonly statement: Statement;
}

/** A change that has not been tried yet. */
export interface Change {
  readonly subject: ChangeSubject;
  /** Makes the changed program; null or a refusal where that is impossible. A long program makes it slow. */
  readonly edit: () => Program | Refusal | null;
  /** Expected worth, s: the order of the tries. */
  readonly expected: number;
  /** All that it does, where it only replaces blocks: such changes can be made together. */
  readonly replaced?: readonly Replacement[];
}

export const changeOf = (subject: ChangeSubject, expected: number, edit: Change["edit"]): Change => ({
  subject,
  edit,
  expected,
});

/** A change that only replaces blocks. */
export const changeOfBlocks = (
  program: Program,
  subject: ChangeSubject,
  expected: number,
  replaced: readonly Replacement[],
): Change => ({
  subject,
  expected,
  replaced,
  edit: () => replaced.reduce((made, { index, statement }) => withBlock(made, index, statement), program),
});

/** The program of a change; null where it is impossible. */
export function changedProgram({ edit }: Change): Program | null {
  const made = edit();
  return made === null || isRefused(made) ? null : made;
}
