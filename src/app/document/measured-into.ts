import { createContext } from "react";
import type { Kind } from "../../cycles/params.ts";
import type { Counting } from "../../view/measure/distance.ts";

/** The open prompt, for what is measured in the picture. */
export interface MeasuredTarget {
  readonly q: string;
  readonly kind: Kind;
  /** How the block of the prompt counts. */
  readonly counts: Counting;
  readonly take: (value: number) => void;
}

/** Where a measured value can go; null while no prompt that holds a number is open. */
export const MeasuredInto = createContext<MeasuredTarget | null>(null);
