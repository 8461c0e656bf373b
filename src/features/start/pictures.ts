import type { ExampleId } from "../../examples/index.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import type { Bounds } from "../../view/camera.ts";
import type { Thumbnail, ViewBox } from "../../view/thumbnail.ts";
import type { RunningPass } from "./running-pass.ts";

/** Themes of the page. */
export type Theme = "light" | "dark";

/** A drawing of the lathe view as SVG elements. */
export interface StillPicture {
  /** The frame of the view in the drawing, which reaches beyond it. */
  readonly box: ViewBox;
  readonly material: Readonly<Record<Theme, string>>;
  /** Path, contour and tool, in the colours of the style sheets. */
  readonly lines: string;
}

/** A program that is played on the lathe view of the start page. */
export interface HeroProgram {
  readonly text: string;
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
  readonly still: StillPicture;
}

export interface StartPictures {
  readonly hero: HeroProgram;
  readonly examples: Readonly<Partial<Record<ExampleId, Thumbnail>>>;
}
