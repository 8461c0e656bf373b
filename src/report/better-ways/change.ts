import type { Program } from "../../nc/program.ts";
import { isRefused, type Refusal } from "../../program/edits/operation-edits.ts";

/** What a change does; each kind is a file of `kinds/` and a line of its table. */
export type ChangeKind =
  | "noCut"
  | "fewerTools"
  | "fewerChanges"
  | "restOperation"
  | "otherTool"
  | "otherCycle"
  | "otherChoice"
  | "infeed"
  | "start"
  | "oneCall"
  | "cuttingSpeed"
  | "feed";

/** The subject of a change, for its words. */
export interface ChangeSubject {
  readonly kind: ChangeKind;
  /** The operations it is about, by index in the program before; the first one is changed. */
  readonly units: readonly number[];
  /** The tool that takes the work, and the one that it takes it from. */
  readonly tool?: number;
  readonly instead?: number;
  /** The new cycle. */
  readonly cycle?: number;
  /** A changed value: the parameter, before and after, and the limit that it keeps, in the unit of the program. */
  readonly value?: { readonly at: string; readonly from: number; readonly to: number; readonly most?: number };
}

/** A change that has not been tried yet. */
export interface Change {
  readonly subject: ChangeSubject;
  /** Makes the changed program; null or a refusal where that is impossible. A long program makes it slow. */
  readonly edit: () => Program | Refusal | null;
  /** Expected worth, s: the order of the tries. */
  readonly expected: number;
}

export const changeOf = (subject: ChangeSubject, expected: number, edit: Change["edit"]): Change => ({
  subject,
  edit,
  expected,
});

/** The program of a change; null where it is impossible. */
export function changedProgram({ edit }: Change): Program | null {
  const made = edit();
  return made === null || isRefused(made) ? null : made;
}
