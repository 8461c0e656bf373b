import type { Group } from "../cycles/define.ts";

/** Words of the shop that no name of a cycle holds, for the search. */
export interface ShopWords {
  /** What one asks for when any cycle of a group may be meant. */
  readonly groups: Readonly<Record<Group, readonly string[]>>;
  /** What one asks for when the contour is a subprogram. */
  readonly free: readonly string[];
  /** Words for the same thing: whoever types one finds the others too. */
  readonly same: readonly (readonly string[])[];
}
