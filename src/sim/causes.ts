import type { Code, Issue } from "../kernel/plan/issue.ts";

/** A simulation issue with its place; block and operation are null for residual material found at the end. */
export interface ProofIssue {
  readonly issue: Issue;
  readonly step: number | null;
  readonly block: number | null;
  readonly operation: number | null;
}

/** Questions about a dimension of the drawing whose sign or order is impossible. */
export const QUESTIONS: ReadonlySet<string> = new Set<Code>([
  "endInFront",
  "startInFront",
  "endsExchanged",
  "diameterOutside",
  "diameterInSolid",
  "diameterNegative",
]);

/** Consequences of an operation without a tool path: the run has already reported the error of values, tool or plan. */
const FOLLOWS_FAILURE: readonly Code[] = ["nothingCut", "airPasses", "materialLeft"];
/** Consequences of a questioned dimension: every tool and stock issue of that operation except damage. */
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
  "cameLoose",
]);

/** Whether a finding follows from a dimension that is questioned at the same operation. */
export const followsQuestion = (code: string): boolean => FOLLOWS_QUESTION.has(code);

/** Operations whose run has already reported why they did not cut as intended. */
export interface Explained {
  readonly failed: ReadonlySet<number>;
  readonly questioned: ReadonlySet<number>;
}
const NONE: Explained = { failed: new Set(), questioned: new Set() };

/**
 * Issues caused by another one at the same operation (outside operations: at the same block). Only the cause is
 * reported.
 */
const FOLLOWS: Readonly<Partial<Record<Code, readonly Code[]>>> = {
  cutOnLoosePiece: ["nothingCut", "airPasses", "deeperThanInfeed", "materialLeft"],
  threadOverruns: ["gouge", "rapidInStock", "holderContact", "deeperThanInfeed"],
  nothingCut: ["materialLeft"],
};

const sameWork = (a: ProofIssue, b: ProofIssue): boolean =>
  a.operation === null ? b.operation === null && a.block === b.block : a.operation === b.operation;

/** A rapid into the finished part is reported as a rapid, not as contour damage. */
const isRapidAlike = ({ issue, step }: ProofIssue, other: ProofIssue): boolean =>
  issue.code === "gouge" && other.issue.code === "rapidInStock" && other.step === step;

const isExplained = ({ issue, operation }: ProofIssue, { failed, questioned }: Explained): boolean =>
  operation !== null &&
  ((failed.has(operation) && FOLLOWS_FAILURE.includes(issue.code)) ||
    (questioned.has(operation) && followsQuestion(issue.code)));

/** Findings without those that another finding, or the run itself, explains. */
export const withoutConsequences = (found: readonly ProofIssue[], explained: Explained = NONE): ProofIssue[] =>
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
