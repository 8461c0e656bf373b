import { nominalOfBore } from "./metric-thread.ts";
import { threadRelief, type ReliefForm } from "./thread-relief.ts";
import type { Diameter } from "../units.ts";

/** Dimensions of an undercut, mm. */
export interface UndercutMeasures {
  readonly R: number;
  readonly DEPTH: number;
  readonly BREADTH: number;
  readonly FACEDEPTH: number;
}

/**
 * Up to diameter: radius, depth, breadth, depth into the face. DIN 509, forms E and F, printed for HEIDENHAIN lathes
 * (tag L: MANUALplus 620 p. 581, CNC PILOT 640 p. 617; decision 0005).
 */
const DIN_509: readonly (readonly [upTo: number, R: number, DEPTH: number, BREADTH: number, FACEDEPTH: number])[] = [
  [1.6, 0.1, 0.1, 0.5, 0.1],
  [3, 0.2, 0.1, 1, 0.1],
  [10, 0.2, 0.2, 2, 0.1],
  [18, 0.6, 0.2, 2, 0.1],
  [80, 0.6, 0.3, 2.5, 0.2],
  [Infinity, 1, 0.4, 4, 0.3],
];

/** DIN 509 dimensions for a shaft or bore of this diameter. */
export function undercutOfDiameter(diameter: Diameter): UndercutMeasures {
  const row = DIN_509.find(([upTo]) => diameter <= upTo) ?? DIN_509[DIN_509.length - 1];
  const [, R, DEPTH, BREADTH, FACEDEPTH] = row ?? [0, 0, 0, 0, 0];
  return { R, DEPTH, BREADTH, FACEDEPTH };
}

/** The thread that an undercut belongs to: a shaft, or a bore with its programmed diameter. */
export type ThreadedCylinder = "shaft" | { readonly bore: Diameter };

/**
 * DIN 76 dimensions for a thread of this pitch, which an inch program states rounded; null for an unlisted pitch.
 * Inside the floor lies at nominal + I, so its depth counts from the bore: (nominal + I − bore) / 2.
 */
export function undercutOfPitch(
  pitch: number,
  cylinder: ThreadedCylinder,
  form: ReliefForm = cylinder === "shaft" ? "A" : "C",
): UndercutMeasures | null {
  const relief = threadRelief(pitch, form);
  if (!relief) return null;
  const { pitch: listed, R, apart, broad: BREADTH } = relief;
  const difference = cylinder === "shaft" ? apart : nominalOfBore(cylinder.bore, listed) + apart - cylinder.bore;
  return { R, DEPTH: difference / 2, BREADTH, FACEDEPTH: 0 };
}
