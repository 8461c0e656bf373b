import type { Spindle } from "../../kernel/time/step.ts";

/** A value of each axis. X counts as the slide goes, not on the diameter. */
export interface OfAxes {
  readonly x: number;
  readonly z: number;
}

/** A torque that the spindle has at a speed: rpm, Nm. */
export interface TorquePoint {
  readonly speed: number;
  readonly torque: number;
}

/** What the turning spindle can do. */
export interface SpindleData {
  /** Fastest speed, rpm. */
  readonly most: number;
  /** From rest to the fastest speed, s. */
  readonly runUp?: number;
  /** kW. */
  readonly power?: number;
  /** By rising speeds; straight between two of them, and as at the nearest beyond. */
  readonly torque?: readonly TorquePoint[];
}

/** What a machine can do, as far as its owner has said so. Its M functions are those of the NC output. */
export interface MachineData {
  readonly name: string;
  /** Rapid rates, mm/min. */
  readonly rapid?: OfAxes;
  /** Accelerations at rapid, m/s²; only beside rates. */
  readonly acceleration?: OfAxes;
  /** From cut to cut as far as no motion is programmed for it, s. */
  readonly toolChange?: number;
  readonly spindle?: SpindleData;
}

/** How the spindle turns: as it is programmed, M4 and its like backwards. */
export interface SpindleTurns {
  readonly spindle: Spindle;
  readonly backwards: boolean;
}

/** A machine, as far as there are data of it, and the rapid rate that counts where it states none, mm/min. */
export interface MachineTimed {
  readonly rapid: number;
  readonly machine?: MachineData;
}

/**
 * Power of a spindle at a speed in rpm, kW: what its torque gives, and never more than its power; null where neither is
 * stated.
 */
export function powerAt({ power, torque = [] }: SpindleData, speed: number): number | null {
  const above = torque.findIndex((point) => point.speed >= speed);
  const [low, high] = [
    torque[above < 0 ? torque.length - 1 : Math.max(0, above - 1)],
    torque[above < 0 ? torque.length - 1 : above],
  ];
  if (!low || !high) return power ?? null;
  const share = high.speed > low.speed ? Math.max(0, speed - low.speed) / (high.speed - low.speed) : 0;
  const given = ((low.torque + (high.torque - low.torque) * share) * 2 * Math.PI * speed) / 60_000;
  return Math.min(power ?? Infinity, given);
}
