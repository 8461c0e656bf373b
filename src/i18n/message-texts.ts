import type { Issue, Reason } from "../kernel/plan/issue.ts";
import type { NcIssue } from "../nc/issue.ts";
import type { ProgramIssue } from "../program/state/issue.ts";
import type { Write } from "./write.ts";

/** A finding of any layer. Findings of the text have a line and a column instead of a field. */
export type AnyIssue = Issue | (NcIssue & { readonly at?: undefined }) | ProgramIssue;
export type AnyCode = AnyIssue["code"];

/** One sentence for each code, made from its data; a forgotten code is a compile error in each language. */
export type Sentences = {
  readonly [C in AnyCode]: (data: Extract<AnyIssue, { code: C }>["data"], write: Write) => string;
};

export interface MessagesTexts {
  /** Why material is left, as a phrase after "left by". */
  readonly reasons: Readonly<Record<Reason, string>>;
  /** A place with the number of further places, as a phrase after "at". */
  readonly morePlaces: (place: string, more: number) => string;
  readonly of: Sentences;
}
