import type { Group } from "../cycles/define.ts";

/** Shop terms for the search that no cycle name contains. */
export interface ShopWords {
  /** Terms that match every cycle of a group. */
  readonly groups: Readonly<Record<Group, readonly string[]>>;
  /** Terms that match the cycles of a contour subprogram. */
  readonly free: readonly string[];
  /** Synonyms: typing one finds the others too. */
  readonly same: readonly (readonly string[])[];
}
