import type { ExampleId } from "../../examples/index.ts";
import type { ViewBox, Thumbnail } from "../../view/thumbnail.ts";

/** One place of the tool's tip on its way. */
export type Waypoint = readonly [
  milliseconds: number,
  z: number,
  r: number,
  /** Index of the stock that stands as soon as the tool has passed. */
  stock: number,
  /** Roughing pass from 1; 0 while the tool is positioned, -1 while it finishes. */
  pass: number,
];

/** A program as it runs, for a picture that plays. */
export interface LiveRun {
  readonly cycle: number;
  readonly box: ViewBox;
  /** The plane at the rear end of the blank, with its hatch. */
  readonly held: string;
  /** Path data, from the blank to the finished part. */
  readonly stocks: readonly string[];
  readonly insert: string;
  /** The whole way of the tool. */
  readonly rapids: string;
  readonly feeds: string;
  readonly way: readonly Waypoint[];
  /** What the values make: passes, infeed in mm, seconds, and whether it is proved. */
  readonly passes: number;
  readonly infeed: number;
  readonly seconds: number;
  readonly proved: boolean;
}

export interface StartPictures {
  readonly live: LiveRun;
  readonly examples: Readonly<Partial<Record<ExampleId, Thumbnail>>>;
}
