import { SAME_STEP } from "../tolerance.ts";
import type { NamedThread, StandardId } from "./named-thread.ts";
import type { TypedName } from "./typed-name.ts";

/** A standard that names threads. */
export interface ThreadStandard {
  readonly id: StandardId;
  /** Its documents. */
  readonly documents: string;
  /**
   * Evidence of its figures (decision 0051). L: depths and angles printed for a HEIDENHAIN lathe (MANUALplus 620 p.
   * 572), sizes compared with public tables; K1: all compared with public tables only.
   */
  readonly evidence: "L" | "K1";
  /** Names in its tables, usual ones first. */
  readonly names: readonly string[];
  /** The thread of a typed name; null for a name of another standard or a size that it cannot have. */
  readonly read: (typed: TypedName) => NamedThread | null;
}

/** Sizes that are no misprint: largest diameter and coarsest pitch, mm; largest pitch in diameters. */
const [LARGEST, COARSEST, STEEPEST] = [1000, 50, 0.4];

/** Whether diameter and pitch (mm) can be a thread at all. */
export const isPlausible = (nominal: number, pitch: number): boolean =>
  nominal > 0 && nominal <= LARGEST && pitch > 0 && pitch <= COARSEST && pitch < STEEPEST * nominal;

/** Most starts of a named thread. */
const MOST_STARTS = 24;

/** Pitch and starts from a lead and its pitch ("14 P7"); null unless one is a multiple of the other. */
export function startsOf(
  lead: number,
  pitch: number | undefined,
): { readonly pitch: number; readonly starts: number } | null {
  if (pitch === undefined) return { pitch: lead, starts: 1 };
  const starts = Math.round(lead / pitch);
  return starts >= 1 && starts <= MOST_STARTS && Math.abs(lead - starts * pitch) < SAME_STEP ? { pitch, starts } : null;
}
