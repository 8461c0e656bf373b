import type { ThreadFill } from "../../../cycles/thread-values.ts";
import type { NamedThread } from "../../../kernel/thread/named-thread.ts";

/** Diameter of a blank in the set-up of a job. */
export interface SetBlank {
  readonly place: "outside" | "bore";
  readonly text: string;
}

/**
 * Diameter of the blank of a job that consists of this thread only, mm: its shaft or its bore. Null for a taper, which
 * no cylinder is the blank of.
 */
export const blankOfThread = (
  { taper }: NamedThread,
  { inside, cut }: ThreadFill,
): { readonly place: SetBlank["place"]; readonly size: number } | null =>
  taper > 0 ? null : { place: inside ? "bore" : "outside", size: cut.crest };
