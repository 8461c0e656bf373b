import type { Tool } from "../../src/kernel/plan/tool.ts";
import { degrees, length } from "../../src/kernel/units.ts";
import { shippedTools } from "../../src/program/tools/shipped-tools.ts";
import { standardDrills } from "../../src/program/tools/standard-drills.ts";
import { readList, shippedList } from "../../src/program/tools/tool-list.ts";

/** A boring bar, mm: shank diameter, and f, the distance of the tip from its axis. */
interface Bar {
  readonly d: number;
  readonly f: number;
  /** From the tip to the end of the shank along Z. */
  readonly z: number;
  /** Corners of a head under the insert. */
  readonly head?: readonly (readonly [number, number])[];
}

const bar = (tool: Partial<Tool> & Pick<Tool, "T" | "NAME" | "TYPE" | "TO" | "RS">, { d, f, z, head }: Bar): Tool => ({
  ...tool,
  holder: {
    width: length(d),
    length: length(100),
    offsetZ: length(z),
    offsetX: length(d / 2 - f),
    ...(head && { head: [head.map(([along, across]) => [length(along), length(across)] as const)] }),
  },
});

const headOf = (d: number, f: number) =>
  [
    [1.1, -1.1],
    [6, -1.5],
    [8, d / 2 - f],
    [8, -f - d / 2],
    [4, 2 - f - d / 2],
    [1.7, -5],
  ] as const;

const turning = (T: number, NAME: string, TYPE: Tool["TYPE"], angles: readonly [number, number], RS: number) => ({
  T,
  NAME,
  TYPE,
  TO: 7 as const,
  RS: length(RS),
  "T-ANGLE": degrees(angles[0]),
  "P-ANGLE": degrees(angles[1]),
  CUTLENGTH: length(6),
});

/** Bars for small bores, beside the shipped tools. */
export const smallBars: readonly Tool[] = [
  bar(turning(51, "A12-SCLCR06", "ROUGH", [95, 80], 0.4), { d: 12, f: 9, z: 8, head: headOf(12, 9) }),
  bar(turning(52, "A12-SDUCR07", "FINISH", [93, 55], 0.4), { d: 12, f: 9, z: 8, head: headOf(12, 9) }),
  bar(turning(53, "A08-SCLCR06", "ROUGH", [95, 80], 0.2), { d: 8, f: 5, z: 8, head: headOf(8, 5) }),
  bar(
    { T: 54, NAME: "A12-GROOVE-2", TYPE: "RECESS", TO: 6, RS: length(0.1), CUTWIDTH: length(2), CUTLENGTH: length(4) },
    { d: 12, f: 11, z: -0.8 },
  ),
  bar(
    { T: 55, NAME: "A12-THREAD", TYPE: "THREAD", TO: 6, RS: length(0.1), "P-ANGLE": degrees(60), CUTLENGTH: length(2) },
    { d: 12, f: 8.5, z: -1.4 },
  ),
];

/** The shipped tools with bars for small bores, and the standard drills, taps and centre drills. */
export const workshop = {
  tools: [...shippedTools, ...smallBars],
  mills: readList(standardDrills(shippedList).map((cells, i) => ({ id: `c${i}`, cells }))).table.mills ?? [],
  rapid: 10_000,
};
