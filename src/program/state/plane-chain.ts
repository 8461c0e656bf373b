import type { ApproachRequest, ApproachShape } from "../../kernel/plane/approach.ts";
import type { CornerElement } from "../../kernel/contour/corner.ts";
import type { PlanePoint, PlaneSegment, Side } from "../../kernel/plane/plane.ts";
import type { Feed } from "../../kernel/units.ts";
import type { ApproachForm } from "../../nc/words.ts";

/** The tool axis and the feed of a block; `z` in mm, null while unknown and in turning. A feed of null is rapid. */
export interface Travel {
  readonly fromZ: number | null;
  readonly toZ: number | null;
  readonly feed: Feed | null;
  readonly index: number;
}

/** A programmed element with its travel, corner and lifts. */
export interface ChainItem extends Travel {
  readonly segment: PlaneSegment;
  readonly corner?: { readonly element: CornerElement; readonly feed: Feed | null; readonly index: number };
  /** Moves in the tool axis alone, behind the element. */
  readonly lifts: readonly Travel[];
}

/** The words of an APPR or DEP block. */
export interface ApproachCall extends Travel {
  readonly form: ApproachForm;
  readonly shape: ApproachShape;
  readonly departing: boolean;
  readonly words: Pick<ApproachRequest, "length" | "radius" | "centreAngle">;
  /** APPR: the programmed PA. DEP LCT: the programmed PN; null for the other departures. */
  readonly target: PlanePoint | null;
  readonly pole: PlanePoint | null;
  /** Feed before the block; null when none was programmed. */
  readonly before: number | "rapid" | null;
}

/** How the tool reaches a contour: it is there already, moves there with an RL or RR block, or approaches. */
export type ChainStart =
  | { readonly kind: "here" }
  | ({ readonly kind: "line"; readonly to: PlanePoint } & Travel)
  | {
      readonly kind: "approach";
      readonly call: ApproachCall;
      readonly before: Feed | null;
    };

/** Elements between two changes of RL, RR and R0. */
export interface CompensatedChain {
  readonly side: Side;
  readonly start: ChainStart;
  readonly lifts: readonly Travel[];
  readonly items: readonly ChainItem[];
}

/** Last element of a chain under construction, linked to the earlier ones. */
export interface ChainEnd {
  readonly item: ChainItem;
  readonly before: ChainEnd | null;
  readonly count: number;
}

export const chainEnd = (item: ChainItem, before: ChainEnd | null): ChainEnd => ({
  item,
  before,
  count: (before?.count ?? 0) + 1,
});

/** The elements up to an end, in their order. */
export function itemsOf(end: ChainEnd | null): readonly ChainItem[] {
  const items: ChainItem[] = [];
  for (let each = end; each; each = each.before) items.push(each.item);
  return items.reverse();
}

/** A chain under construction. */
export interface OpenChain extends Omit<CompensatedChain, "items"> {
  readonly end: ChainEnd | null;
}

/** A chain under construction, and the actual position of the programmed point (mill centre, or tip). */
export interface Guide {
  chain: OpenChain | null;
  here: PlanePoint | null;
}
