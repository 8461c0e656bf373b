import type { PlanePoint, PlaneSegment } from "../../kernel/plane/plane.ts";
import type { Machine } from "../state/machine.ts";
import type { Travel } from "../state/plane-chain.ts";
import type { ApproachRun } from "../tools/plane-types.ts";

/** Executes a chain: a mill in X/Y or a turning tool in Z/X. */
export interface Carrier {
  readonly machine: Machine;
  readonly plane: "XY" | "ZX";
  /** Distance of the tool centre from the contour, mm. */
  readonly toolRadius: number;
  /** Vector from the tool centre to the programmed point; zero for a mill. */
  readonly tip: PlanePoint;
  /** Upper side of the part in the tool axis, where one is known. */
  readonly top: number | null;
  /** Runs a path of the programmed point. */
  readonly emit: (s: PlaneSegment, travel: Travel) => void;
  /** The first position, reached from an unknown one. */
  readonly arrive: (at: PlanePoint, travel: Travel) => void;
  readonly note: (run: ApproachRun) => void;
}
