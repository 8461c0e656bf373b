import type { Wanted } from "../../cycles/wanted.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import type { Tried } from "../../report/which/try-way.ts";
import type { Proposal } from "../../report/which/ways.ts";

/** What finds ways and tries them: the worker, or in a test the functions themselves. */
export interface Comparer {
  readonly ways: (wanted: Wanted, stock: readonly Ring[] | null) => Promise<readonly Proposal[] | null>;
  readonly tryWay: (proposal: Proposal, wanted: Wanted, stock: readonly Ring[] | null) => Promise<Tried | null>;
}
