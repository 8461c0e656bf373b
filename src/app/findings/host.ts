import type { FindingEntry } from "./entry.ts";

/** A button that mends what a finding says, in one step of undo. */
export interface Mend {
  readonly name: string;
  readonly apply: () => void;
}

/** Where a finding is mended by hand. */
export interface Target {
  readonly name: string;
  readonly go: () => void;
}

/** What a workplace does for the list of findings: it knows prompts, blocks and how to change them. */
export interface FindingsHost {
  readonly targetOf: (entry: FindingEntry) => Target | null;
  readonly remediesOf: (entry: FindingEntry) => readonly Mend[];
  /** The cycle in whose definition a finding stands: it tells what the value at its place measures. */
  readonly cycleOf: (entry: FindingEntry) => number | null;
  /** Marks the place of a finding beside the list, without leaving the list. */
  readonly point: (entry: FindingEntry) => void;
  /** Opens the first prompt that is not answered yet. */
  readonly toFirstOpen: () => void;
  /** Gives the operation of a finding another tool. */
  readonly takeTool: (entry: FindingEntry, tool: number) => void;
}

/** The value that a finding offers; null where it offers none. */
export const nearestOf = ({ issue }: FindingEntry): number | null =>
  "nearest" in issue.data && typeof issue.data.nearest === "number" && Number.isFinite(issue.data.nearest)
    ? issue.data.nearest
    : null;
