import type { ShapeRequest } from "../../cycles/shape-request.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import type { TriedOption } from "../../report/which/try-way.ts";
import type { Proposal } from "../../report/which/ways.ts";

/** Finds operations and simulates them: in the worker, or in a test directly. */
export interface Comparer {
  readonly ways: (wanted: ShapeRequest, stock: readonly Ring[] | null) => Promise<readonly Proposal[] | null>;
  readonly tryWay: (
    proposal: Proposal,
    wanted: ShapeRequest,
    stock: readonly Ring[] | null,
  ) => Promise<TriedOption | null>;
}
