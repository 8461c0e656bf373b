import type { Issue, Reason } from "../kernel/plan/issue.ts";
import type { NcIssue } from "../nc/issue.ts";
import type { ProgramIssue } from "../program/state/issue.ts";
import type { Write } from "./write.ts";

/** A finding of any layer. Those of the text have a line and a column instead of a field. */
export type AnyIssue = Issue | (NcIssue & { readonly at?: undefined }) | ProgramIssue;
export type AnyCode = AnyIssue["code"];

/** One sentence for each code, made from its data; a forgotten code is a compile error in each language. */
export type Sentences = {
  readonly [C in AnyCode]: (data: Extract<AnyIssue, { code: C }>["data"], write: Write) => string;
};

export interface MessagesTexts {
  /** Why material stays, as it follows "left by". */
  readonly reasons: Readonly<Record<Reason, string>>;
  /** A place with the number of further ones, as it follows "at". */
  readonly morePlaces: (place: string, more: number) => string;
  readonly of: Sentences;
}
