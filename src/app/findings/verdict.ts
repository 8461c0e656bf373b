import { verdictOf, type VerdictReason } from "../../report/verdict.ts";
import type { Outcome } from "../calculation/outcome.ts";
import { isError, isToDo, type FindingEntry } from "./entry.ts";

/** Why a program is not or only partly verified, with the data of the sentence. */
export type Doubt =
  | Extract<VerdictReason, { kind: "unproved" | "milling" | "notes" }>
  | { readonly kind: "nothingCut"; readonly block: number; readonly cycle: number }
  /**
   * `begun`: something is cut or drawn all the same, or a cycle is defined but not called; `turned`: moves cut without
   * a cycle.
   */
  | {
      readonly kind: "noOperation";
      readonly approachesClear: boolean;
      readonly begun: boolean;
      readonly turned: boolean;
    }
  /** All incompletely described tools, in one sentence. */
  | { readonly kind: "holderUnknown" | "flanksUnknown" | "curvatureUnknown"; readonly tools: readonly number[] };

/** The shown verdict on a program: that of the report, and what the list of findings adds. */
export interface ShownVerdict {
  /** "none": there is nothing calculated to judge. */
  readonly state: "none" | "proved" | "faults" | "incomplete";
  /** The gravest first. */
  readonly doubts: readonly Doubt[];
  /** Errors, without empty prompts. */
  readonly faults: number;
  /** The called program that has the first of them; null for the main program. */
  readonly file: string | null;
  /** Prompts that are still empty. */
  readonly open: number;
  readonly warnings: number;
  /** Residual material, mm². */
  readonly residualArea: number;
}

function doubtsOf(
  reasons: readonly VerdictReason[],
  entries: readonly FindingEntry[],
  { run }: Outcome,
): readonly Doubt[] {
  const doubts: Doubt[] = [];
  for (const reason of reasons) {
    switch (reason.kind) {
      case "unproved":
      case "milling":
      case "notes":
        doubts.push(reason);
        break;
      case "nothingCut":
        doubts.push({ kind: "nothingCut", block: reason.block, cycle: run.operations[reason.operation]?.cycle ?? 0 });
        break;
      case "noOperation": {
        const turned = run.steps.some(({ move }) => move.kind !== "rapid");
        doubts.push({
          kind: "noOperation",
          turned,
          approachesClear: run.approaches.length > 0 && !entries.some((e) => e.spot?.kind === "finding"),
          begun: entries.length > 0 || run.approaches.length > 0 || run.plane.length > 0 || turned,
        });
        break;
      }
      default:
        break;
    }
  }
  for (const kind of ["holderUnknown", "flanksUnknown", "curvatureUnknown"] as const) {
    const tools = reasons.flatMap((r) => (r.kind === kind ? [r.tool] : [])).sort((a, b) => a - b);
    if (tools.length > 0) doubts.push({ kind, tools });
  }
  return doubts;
}

/** The verdict on the calculated program, with all reasons. Errors of the prompts count as well. */
export function shownVerdict(entries: readonly FindingEntry[], outcome: Outcome | null): ShownVerdict {
  const errors = entries.filter(isError);
  const open = errors.filter(isToDo).length;
  const faults = errors.length - open;
  const file = errors.find((entry) => !isToDo(entry))?.inFile?.file ?? null;
  const warnings = entries.filter((e) => e.issue.severity === "warning" && e.issue.code !== "materialLeft").length;
  const residualArea = entries.reduce(
    (sum, { issue }) => (issue.code === "materialLeft" && issue.severity !== "info" ? sum + issue.data.area : sum),
    0,
  );
  const counts = { faults, file, open, warnings, residualArea };
  if (!outcome) return { state: faults > 0 ? "faults" : "none", doubts: [], ...counts };
  const { verdict, reasons } = verdictOf(outcome.run, outcome.simulation);
  const state = faults > 0 ? "faults" : verdict;
  return {
    state,
    doubts: doubtsOf(reasons, entries, outcome),
    ...counts,
    faults: Math.max(faults, state === "faults" ? 1 : 0),
  };
}

/** Green only if everything is verified and nothing is left unchecked or needs a look. An empty page is no doubt. */
export function toneOf({
  state,
  doubts,
  warnings,
  residualArea,
}: ShownVerdict): "good" | "plain" | "doubt" | "bad" | "none" {
  if (state === "none") return "none";
  if (state === "faults") return "bad";
  if (doubts.length > 0 && doubts.every((doubt) => doubt.kind === "noOperation" && !doubt.begun)) return "none";
  if (state === "incomplete" || doubts.length > 0) return "doubt";
  return warnings > 0 || residualArea > 0 ? "plain" : "good";
}
