import type { Pt } from "../../kernel/geometry/point.ts";
import type { Severity } from "../../kernel/plan/issue.ts";
import type { AnyIssue } from "../../i18n/message-texts.ts";
import { QUESTIONS } from "../../sim/causes.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import type { Bounds } from "../../view/camera.ts";
import { BESIDE_CELLS } from "../../program/tools/tool-columns.ts";
import type { RunFinding } from "../../program/state/run-types.ts";

/** The place of a finding in the picture, and its position in the playback. */
export interface FindingSpot {
  /** The section of the lathe, or the working plane of milling (X to the right, Y up, as points z and r). */
  readonly plane: "ZX" | "XY";
  readonly kind: "finding" | "residual";
  /** Number of a finding, letter of residual material: the same in list and picture. */
  readonly mark: string;
  readonly place: Pt;
  /** Its bounding box, mm. */
  readonly bounds: Bounds;
  readonly position: PlayPosition;
}

/** One line of the list of findings, from a prompt, the contour table, the run or the stock. */
export interface FindingEntry {
  /** Id of the line while nothing changes. */
  readonly id: string;
  readonly issue: AnyIssue;
  /** The field it belongs to: a Q number, "start.x", "tool", "contour" …; null when it belongs to none. */
  readonly at: string | null;
  /** Number of its block; null when it belongs to none. */
  readonly block: number | null;
  /** Line of the program text, from 1; null when it belongs to none. */
  readonly line: number | null;
  /** Its place in the file of a called program; block and line are then those of the call. */
  readonly inFile?: RunFinding["inFile"] | undefined;
  /** Index of its operation in the run. */
  readonly operation: number | null;
  readonly spot: FindingSpot | null;
  /** Index into the residual material of the check. */
  readonly residual: number | null;
  /** Diameter of the largest circle in the residual material, over all places of the finding, mm. */
  readonly thickness: number | null;
}

const toDo: ReadonlySet<string> = new Set(["missing", "unknownParameter"]);

/** An empty prompt, or a Q parameter without a value: something to do, not an error. */
export const isOpen = ({ issue }: Pick<FindingEntry, "issue">): boolean => toDo.has(issue.code);

/** The same in the list: a value missing in a program is an error, an empty prompt is none. */
export const isToDo = (entry: Pick<FindingEntry, "issue" | "block">): boolean => entry.block === null && isOpen(entry);

export const isError = ({ issue }: Pick<FindingEntry, "issue">): boolean => issue.severity === "error";

/** The places of findings about a tool: the tool, or a column of the tool table. */
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
  ...BESIDE_CELLS,
]);
export const isAboutTool = (at: string | null): boolean => at !== null && toolPlaces.has(at);

const weight: Readonly<Record<Severity, number>> = { error: 0, warning: 1, info: 2 };

/** The worst severity has the lowest weight. */
export const weightOf = (severity: Severity): number => weight[severity];

/** Findings of the stock. They come after those of the program, and residual material last: causes before effects. */
const stockFindings: ReadonlySet<string> = new Set([
  "gouge",
  "threadOverruns",
  "rapidInStock",
  "holderContact",
  "cutOnLoosePiece",
  "behindBlank",
  "cutBelowContour",
  "intendedCut",
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
  return code === "materialLeft" ? 2 : Number(stockFindings.has(code));
}

/** Worst first; among equals causes before effects, then in the order of the text. */
export const inOrder = (entries: readonly FindingEntry[]): readonly FindingEntry[] =>
  entries.toSorted((a, b) => weight[a.issue.severity] - weight[b.issue.severity] || stage(a) - stage(b));

/** A finding at a field or block, without a place in the picture. */
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
