import type { Wanted } from "../../cycles/wanted.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import type { Tried } from "../../report/which/try-way.ts";
import type { Proposal } from "../../report/which/ways.ts";

/** Finds operations and simulates them: in the worker, or in a test directly. */
export interface Comparer {
  readonly ways: (wanted: Wanted, stock: readonly Ring[] | null) => Promise<readonly Proposal[] | null>;
  readonly tryWay: (proposal: Proposal, wanted: Wanted, stock: readonly Ring[] | null) => Promise<Tried | null>;
}
