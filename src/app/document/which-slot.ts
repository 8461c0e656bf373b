import type { ComponentType } from "react";
import { slot } from "../base/slot.ts";
import type { WhichRegion } from "../place/place.ts";

/** The dialog that finds a cycle for a shape, over the picture or a program. */
export const whichSlot = slot<
  ComponentType<{
    readonly done: () => void;
    readonly region: WhichRegion | null;
    /** The operation of the open program behind which a proposal is inserted; null: in front of all. */
    readonly behind?: number | null;
  }>
>("which cycle");
