import type { ExampleId } from "../../examples/index.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import type { Bounds } from "../../view/camera.ts";
import type { Thumbnail, ViewBox } from "../../view/thumbnail.ts";
import type { RunningPass } from "./running-pass.ts";

/** Themes of the page. */
export type Theme = "light" | "dark";

/** A program that is played on the lathe view of the start page. */
export interface HeroProgram {
  /** The section of the lathe that is shown. */
  readonly frame: Bounds;
  /** Where playback begins: the moment of the still picture. */
  readonly at: PlayPosition;
  readonly running: RunningPass;
  /** Facts of the program: operations, tools, seconds, and whether it is verified. */
  readonly operations: number;
  readonly tools: number;
  readonly seconds: number;
  readonly proved: boolean;
  /** The frame in the still picture, which reaches beyond it. */
  readonly box: ViewBox;
}

export interface StartPictures {
  readonly hero: HeroProgram;
  readonly examples: Readonly<Partial<Record<ExampleId, Thumbnail>>>;
}
