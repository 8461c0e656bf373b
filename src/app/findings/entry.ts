import type { Pt } from "../../kernel/geometry/point.ts";
import type { Severity } from "../../kernel/plan/issue.ts";
import type { AnyIssue } from "../../i18n/message-texts.ts";
import { QUESTIONS } from "../../sim/causes.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import type { Bounds } from "../../view/camera.ts";
import type { RunFinding } from "../../program/state/run-types.ts";

/** Where a finding is to be seen in the picture, and when. */
export interface FindingSpot {
  /** The section of the lathe, or the working plane of milling (X to the right, Y up, as points z and r). */
  readonly plane: "ZX" | "XY";
  readonly kind: "finding" | "residual";
  /** Number of a finding, letter of a region that stays: the same in list and picture. */
  readonly mark: string;
  readonly place: Pt;
  /** The box round it, mm. */
  readonly bounds: Bounds;
  readonly position: PlayPosition;
}

/** One line of the list of findings, whatever found it: a prompt, the contour table, the run or the stock. */
export interface FindingEntry {
  /** Names the line as long as nothing changes. */
  readonly id: string;
  readonly issue: AnyIssue;
  /** The field it belongs to: a Q number, "start.x", "tool", "contour" …; null when it belongs to none. */
  readonly at: string | null;
  /** Number of its block; null when it belongs to none. */
  readonly block: number | null;
  /** Line of the program text, from 1; null when it belongs to none. */
  readonly line: number | null;
  /** Where it stands in the file of a called program; block and line are those of the call then. */
  readonly inFile?: RunFinding["inFile"] | undefined;
  /** Index of its operation in the run. */
  readonly operation: number | null;
  readonly spot: FindingSpot | null;
  /** Index into the proof's residue, for what stays. */
  readonly residual: number | null;
  /** Diameter of the largest circle in the residue, in all places of the finding, mm. */
  readonly thickness: number | null;
}

const toDo: ReadonlySet<string> = new Set(["missing", "unknownParameter"]);

/**
 * A prompt that is still empty, or a Q parameter that still waits for its value: something to do, not something done
 * wrong.
 */
export const isOpen = ({ issue }: Pick<FindingEntry, "issue">): boolean => toDo.has(issue.code);

/** The same in the list: what a program lacks is a fault, what is not typed yet is none. */
export const isToDo = (entry: Pick<FindingEntry, "issue" | "block">): boolean => entry.block === null && isOpen(entry);

export const isError = ({ issue }: Pick<FindingEntry, "issue">): boolean => issue.severity === "error";

/** Findings about a tool name it, or the column of the tool table. */
const toolPlaces: ReadonlySet<string> = new Set([
  "tool",
  "T",
  "NAME",
  "TYPE",
  "TO",
  "RS",
  "DRS",
  "ZL",
  "XL",
  "DZL",
  "DXL",
  "DYL",
  "ORI",
  "T-ANGLE",
  "P-ANGLE",
  "CUTLENGTH",
  "CUTWIDTH",
  "DCW",
]);
export const isAboutTool = (at: string | null): boolean => at !== null && toolPlaces.has(at);

const weight: Readonly<Record<Severity, number>> = { error: 0, warning: 1, info: 2 };

/**
 * What was found in the stock comes after what was found in the program, and what stays comes last: causes before
 * effects.
 */
const found: ReadonlySet<string> = new Set([
  "gouge",
  "threadOverruns",
  "rapidInStock",
  "holderContact",
  "cutOnLoosePiece",
  "behindBlank",
  "cutBelowContour",
  "cameLoose",
  "partedOff",
  "clampContact",
  "cutBehindLimit",
  "deeperThanInfeed",
  "crestMissing",
  "nothingCut",
  "airPasses",
]);
function stage({ issue: { code } }: FindingEntry): number {
  if (QUESTIONS.has(code)) return -1;
  return code === "materialLeft" ? 2 : Number(found.has(code));
}

/** Worst first; among equals the cause before its effect, then in the order of the text. */
export const inOrder = (entries: readonly FindingEntry[]): readonly FindingEntry[] =>
  entries.toSorted((a, b) => weight[a.issue.severity] - weight[b.issue.severity] || stage(a) - stage(b));

/** A finding that stands at one field or block and nowhere in the picture. */
export const entryAt = (
  issue: AnyIssue,
  at: string | null,
  block: number | null,
  inFile?: FindingEntry["inFile"],
): FindingEntry => ({
  id: `${issue.code} ${at ?? ""}`,
  issue,
  at,
  block,
  line: null,
  inFile,
  operation: null,
  spot: null,
  residual: null,
  thickness: null,
});
