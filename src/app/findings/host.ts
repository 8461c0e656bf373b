import type { ProgramWork } from "../document/work.ts";
import type { FindingEntry } from "./entry.ts";

/** A button that fixes a finding, in one step of undo. */
export interface Fix {
  readonly name: string;
  readonly apply: () => void;
}

/** A fix that only a run shows to help; of those of one group, the first that helps is offered. */
export interface Trial extends Fix {
  readonly group: string;
  /** The program with the fix; null where it turns out to be impossible. */
  readonly work: () => ProgramWork | Promise<ProgramWork | null>;
}

/** The place where a finding is fixed by hand. */
export interface Target {
  readonly name: string;
  readonly go: () => void;
}

/** The workplace behind the list of findings: it knows prompts, blocks and how to change them. */
export interface FindingsHost {
  readonly targetOf: (entry: FindingEntry) => Target | null;
  readonly fixesOf: (entry: FindingEntry) => readonly Fix[];
  /** Null for a finding without such fixes. */
  readonly trialsOf: (entry: FindingEntry) => Promise<readonly Trial[]> | null;
  /** The cycle whose definition has the finding: it decides what the value at its place measures. */
  readonly cycleOf: (entry: FindingEntry) => number | null;
  /** Marks the place of a finding beside the list, without leaving the list. */
  readonly point: (entry: FindingEntry) => void;
  /** Opens the first prompt that is not answered yet. */
  readonly toFirstOpen: () => void;
  /** False while the findings are those of an older text: a change is offered only for the present one. */
  readonly isCurrent: boolean;
  /** Searches improvements of the open program; null where none may be offered. */
  readonly improve: (() => void) | null;
  /** Gives the operation of a finding another tool. */
  readonly takeTool: (entry: FindingEntry, tool: number) => void;
}

/** The value that a finding proposes, or null. */
export const nearestOf = ({ issue }: FindingEntry): number | null =>
  "nearest" in issue.data && typeof issue.data.nearest === "number" && Number.isFinite(issue.data.nearest)
    ? issue.data.nearest
    : null;
