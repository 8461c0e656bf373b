import type { Spindle } from "../../kernel/time/step.ts";

/** A value of each axis. X counts as the slide goes, not on the diameter. */
export interface OfAxes {
  readonly x: number;
  readonly z: number;
}

/** Torque of the spindle at a speed: rpm, Nm. */
export interface TorquePoint {
  readonly speed: number;
  readonly torque: number;
}

/** Data of the turning spindle. */
export interface SpindleData {
  /** Fastest speed, rpm. */
  readonly most: number;
  /** From rest to the fastest speed, s. */
  readonly runUp?: number;
  /** kW. */
  readonly power?: number;
  /** By increasing speed; linear between two points, constant beyond. */
  readonly torque?: readonly TorquePoint[];
}

/** Data of a machine, as far as stated. Its M functions belong to the NC output. */
export interface MachineData {
  readonly name: string;
  /** Rapid rates, mm/min. */
  readonly rapid?: OfAxes;
  /** Accelerations at rapid, m/s²; only together with rates. */
  readonly acceleration?: OfAxes;
  /** Tool change time, s, without its programmed motions. */
  readonly toolChange?: number;
  readonly spindle?: SpindleData;
}

/** Spindle state: as programmed, reversed with M4 and its like. */
export interface SpindleTurns {
  readonly spindle: Spindle;
  readonly backwards: boolean;
}

/** Known data of a machine, and the default rapid rate, mm/min. */
export interface MachineTimed {
  readonly rapid: number;
  readonly machine?: MachineData;
}

/** Spindle power at a speed in rpm, kW: from its torque, limited by its power; null where neither is stated. */
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
