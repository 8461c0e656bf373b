import type { StatementOf } from "../../nc/statement.ts";
import type { Label } from "../../nc/words.ts";
import type { Parameters } from "../values/formula.ts";
import type { KnownMoment } from "../values/known-values.ts";
import type { LogMoment } from "./log.ts";
import type { Modal, Whereabouts } from "./modal.ts";
import type { Guide } from "./plane-chain.ts";

/**
 * Where a run was between two blocks of its program, while no call had to return: what `Machine` holds, by the same
 * names.
 */
export interface RunMoment {
  readonly now: Modal;
  readonly place: Whereabouts;
  readonly freePole: StatementOf<"free"> | null;
  readonly parameters: Readonly<Parameters>;
  readonly radii: ReadonlyMap<Label, number>;
  readonly definitions: ReadonlySet<number>;
  readonly called: ReadonlySet<number>;
  /** Blocks executed before: what is first looked at later has a higher count. */
  readonly executed: number;
  readonly known: KnownMoment;
  readonly log: LogMoment;
  /** Where the contours of turning and milling stood; none of them is being gathered. */
  readonly here: readonly [turning: Guide["here"], milling: Guide["here"]];
  /** What the memory of plans had been asked. */
  readonly asked: number;
}
