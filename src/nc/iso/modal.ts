import type { FeedWord } from "../words.ts";
import type { IsoNames } from "./names.ts";
import type { IsoMeaning } from "./words.ts";

/** A path function with its meaning. */
export type PathMeaning = Extract<IsoMeaning, { kind: "path" }>;

/** The modal state that a block leaves for the following blocks. */
export interface IsoModal {
  /** Path function, null before the first. */
  readonly path: PathMeaning | null;
  readonly incremental: boolean;
  /** Direction of the last arc that named one. */
  readonly turn: "cw" | "ccw" | null;
  /** The feed of a rapid block: Klartext cannot write it there, so the next feed block gets it. */
  readonly feed: FeedWord | null;
}

export const FIRST_MODAL: IsoModal = { path: null, incremental: false, turn: null, feed: null };

/** The context for reading a block. */
export interface IsoContext {
  readonly modal: IsoModal;
  readonly names: IsoNames;
}
