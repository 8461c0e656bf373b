import type { FeedWord } from "../words.ts";
import type { IsoNames } from "./names.ts";
import type { IsoMeaning } from "./words.ts";

/** A path function with what its word says. */
export type PathMeaning = Extract<IsoMeaning, { kind: "path" }>;

/** What a block leaves in force for the blocks behind it. */
export interface IsoModal {
  /** Path function, null before the first. */
  readonly path: PathMeaning | null;
  readonly incremental: boolean;
  /** Direction of the last arc that named one. */
  readonly turn: "cw" | "ccw" | null;
  /** A feed of a block at rapid: Klartext has no place for it there, so the next block at feed takes it. */
  readonly feed: FeedWord | null;
}

export const FIRST_MODAL: IsoModal = { path: null, incremental: false, turn: null, feed: null };

/** What reading a block needs besides its text. */
export interface IsoContext {
  readonly modal: IsoModal;
  readonly names: IsoNames;
}
