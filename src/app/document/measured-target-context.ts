import { createContext } from "react";
import type { Kind } from "../../cycles/params.ts";
import type { BlockUnits } from "../../view/measure/distance.ts";

/** The open prompt as the target of a measured value. */
export interface MeasuredTarget {
  readonly q: string;
  readonly kind: Kind;
  /** Unit and zero point of the block. */
  readonly counts: BlockUnits;
  readonly take: (value: number) => void;
}

/** The target of a measured value; null while no prompt with a number is open. */
export const MeasuredTargetContext = createContext<MeasuredTarget | null>(null);
