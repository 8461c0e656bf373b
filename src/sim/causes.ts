import type { Code, Issue } from "../kernel/plan/issue.ts";

/** An issue of the proof with where it belongs; block and operation are null for what is left at the end. */
export interface ProofIssue {
  readonly issue: Issue;
  readonly step: number | null;
  readonly block: number | null;
  readonly operation: number | null;
}

/** Questions about a dimension of the drawing whose sign or order is impossible. */
export const QUESTIONS: ReadonlySet<string> = new Set<Code>(["endInFront", "endsExchanged"]);

/**
 * What follows where an error of values, tool or plan kept an operation from its path: that error has been reported by
 * the run.
 */
const FOLLOWS_FAILURE: readonly Code[] = ["nothingCut", "airPasses", "materialLeft"];
/** What follows where a dimension is questioned: all that tool and stock say to it, damage aside. */
const FOLLOWS_QUESTION: ReadonlySet<string> = new Set<Code>([
  ...FOLLOWS_FAILURE,
  "toolUnfit",
  "toolCannotCutSideways",
  "flanksNotChecked",
  "angleNotFollowed",
  "cornerSmallerThanInsert",
  "recessNarrowerThanTool",
  "infeedOverCutLength",
  "depthOverCutLength",
  "nothingToCut",
  "startOnWrongSide",
  "startInPart",
  "startInMaterial",
  "holderContact",
  "deeperThanInfeed",
  "crestMissing",
]);

/** Whether a finding follows from a dimension that is questioned at the same operation. */
export const followsQuestion = (code: string): boolean => FOLLOWS_QUESTION.has(code);

/** Operations whose run has said already why they did not do what was wanted. */
export interface Explained {
  readonly failed: ReadonlySet<number>;
  readonly questioned: ReadonlySet<number>;
}
const NONE: Explained = { failed: new Set(), questioned: new Set() };

/**
 * What follows from a finding at the same operation, or at the same block outside operations: the cause alone is told.
 */
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

const isExplained = ({ issue, operation }: ProofIssue, { failed, questioned }: Explained): boolean =>
  operation !== null &&
  ((failed.has(operation) && FOLLOWS_FAILURE.includes(issue.code)) ||
    (questioned.has(operation) && followsQuestion(issue.code)));

/** Findings without those that follow from another one, or from what the run has said of their operation. */
export const causesAlone = (found: readonly ProofIssue[], explained: Explained = NONE): ProofIssue[] =>
  found.filter(
    (f) =>
      !isExplained(f, explained) &&
      !found.some(
        (cause) =>
          cause !== f &&
          (isRapidAlike(f, cause) ||
            (sameWork(f, cause) && FOLLOWS[cause.issue.code]?.includes(f.issue.code) === true)),
      ),
  );
