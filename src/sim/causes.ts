import type { Code, Issue } from "../kernel/issue.ts";

/** An issue of the proof with where it belongs; block and operation are null for what is left at the end. */
export interface ProofIssue {
  readonly issue: Issue;
  readonly step: number | null;
  readonly block: number | null;
  readonly operation: number | null;
}

/** What follows from a finding at the same operation, or at the same block outside operations: the cause alone is told. */
const FOLLOWS: Readonly<Partial<Record<Code, readonly Code[]>>> = {
  cutOnLoosePiece: ["nothingCut", "airPasses", "deeperThanInfeed", "materialLeft"],
  threadOverruns: ["gouge", "rapidInStock", "holderContact", "deeperThanInfeed"],
  nothingCut: ["materialLeft"],
};

const sameWork = (a: ProofIssue, b: ProofIssue): boolean =>
  a.operation === null ? b.operation === null && a.block === b.block : a.operation === b.operation;

/** A rapid that runs into the finished part is told as a rapid. */
const isRapidAlike = ({ issue, step }: ProofIssue, other: ProofIssue): boolean =>
  issue.code === "gouge" && other.issue.code === "rapidInStock" && other.step === step;

/** Findings without those that follow from another one. */
export const causesAlone = (found: readonly ProofIssue[]): ProofIssue[] =>
  found.filter((f) =>
    !found.some((cause) =>
      cause !== f && (isRapidAlike(f, cause) || (sameWork(f, cause) && FOLLOWS[cause.issue.code]?.includes(f.issue.code) === true))
    )
  );
