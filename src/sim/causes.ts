import type { Code, Issue } from "../kernel/issue.ts";

/** An issue of the proof with where it belongs; block and operation are null for what is left at the end. */
export interface ProofIssue {
  readonly issue: Issue;
  readonly step: number | null;
  readonly block: number | null;
  readonly operation: number | null;
}

/** What follows where an error of values, tool or plan kept an operation from its path: that error has been reported by the run. */
const FOLLOWS_FAILURE: ReadonlySet<Code> = new Set<Code>(["nothingCut", "airPasses", "materialLeft"]);

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

/** Findings without those that follow from another one, or from an error of their operation; `failed` holds the operations with one. */
export const causesAlone = (found: readonly ProofIssue[], failed: ReadonlySet<number> = new Set()): ProofIssue[] =>
  found.filter((f) =>
    !(f.operation !== null && failed.has(f.operation) && FOLLOWS_FAILURE.has(f.issue.code))
    && !found.some((cause) =>
      cause !== f && (isRapidAlike(f, cause) || (sameWork(f, cause) && FOLLOWS[cause.issue.code]?.includes(f.issue.code) === true))
    )
  );
