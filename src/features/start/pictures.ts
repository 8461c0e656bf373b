import type { ExampleId } from "../../examples/index.ts";
import type { ViewBox, Thumbnail } from "../../view/thumbnail.ts";

/** One waypoint of the tool tip. */
export type Waypoint = readonly [
  milliseconds: number,
  z: number,
  r: number,
  /** Index of the stock after the tool has passed. */
  stock: number,
  /** Roughing pass from 1; 0 while the tool is positioned, -1 while it finishes. */
  pass: number,
];

/** The run of a program, for an animated picture. */
export interface LiveRun {
  readonly cycle: number;
  readonly box: ViewBox;
  /** The rear end face of the blank, with its hatch. */
  readonly held: string;
  /** Path data, from the blank to the finished part. */
  readonly stocks: readonly string[];
  readonly insert: string;
  /** The complete tool path. */
  readonly rapids: string;
  readonly feeds: string;
  readonly way: readonly Waypoint[];
  /** Results of the values: passes, infeed in mm, seconds, and whether it is verified. */
  readonly passes: number;
  readonly infeed: number;
  readonly seconds: number;
  readonly proved: boolean;
}

export interface StartPictures {
  readonly live: LiveRun;
  readonly examples: Readonly<Partial<Record<ExampleId, Thumbnail>>>;
}
