import type { MachineData } from "./machine-data.ts";

/** Example machines. Their figures are typical of their class, not of any make: the owner replaces them. */
export const EXAMPLE_MACHINES = {
  small: {
    name: "Turning centre, small",
    rapid: { x: 24_000, z: 30_000 },
    acceleration: { x: 4, z: 5 },
    toolChange: 1.5,
    spindle: {
      most: 6000,
      runUp: 2,
      power: 11,
      torque: [
        { speed: 0, torque: 70 },
        { speed: 1500, torque: 70 },
        { speed: 6000, torque: 17.5 },
      ],
    },
  },
  millTurn: {
    name: "Milling/turning centre",
    rapid: { x: 40_000, z: 40_000 },
    acceleration: { x: 5, z: 5 },
    toolChange: 9,
    spindle: {
      most: 1200,
      runUp: 3,
      power: 40,
      torque: [
        { speed: 0, torque: 950 },
        { speed: 400, torque: 950 },
        { speed: 1200, torque: 318 },
      ],
    },
  },
  large: {
    name: "Lathe, large",
    rapid: { x: 10_000, z: 12_000 },
    acceleration: { x: 1, z: 1 },
    toolChange: 4,
    spindle: {
      most: 1600,
      runUp: 8,
      power: 37,
      torque: [
        { speed: 0, torque: 1400 },
        { speed: 250, torque: 1400 },
        { speed: 1600, torque: 220 },
      ],
    },
  },
} as const satisfies Readonly<Record<string, MachineData>>;
export type ExampleMachine = keyof typeof EXAMPLE_MACHINES;
export const EXAMPLE_MACHINE_NAMES = Object.keys(EXAMPLE_MACHINES) as readonly ExampleMachine[];
