import type { Holder, HolderCorner } from "../../kernel/plan/tool.ts";
import { length } from "../../kernel/units.ts";

type Corner = readonly [z: number, x: number];

/** The shank: width, length, distance from the tip to its near corner, and axis. mm. */
interface Shank {
  readonly width: number;
  readonly length: number;
  readonly z: number;
  readonly x: number;
  readonly axis?: "X" | "Z";
}

const holder = (s: Shank, ...head: readonly (readonly Corner[])[]): Holder => ({
  width: length(s.width),
  length: length(s.length),
  offsetZ: length(s.z),
  offsetX: length(s.x),
  ...(s.axis && { axis: s.axis }),
  head: head.map((part) => part.map(([z, x]): HolderCorner => [length(z), length(x)])),
});

/**
 * A blade behind the edge of a bar that cuts towards −X (`up` 1) or +X (−1): a little narrower than the cut, to its
 * full depth.
 */
const blade = (half: number, depth: number, up: 1 | -1): readonly Corner[] => [
  [-half, 1.5 * up],
  [half, 1.5 * up],
  [half, depth * up],
  [-half, depth * up],
];

/*
 * Catalogue holders by ISO designation: shank 25×25 or 20×20 with f = 32 or, for neutral ones, the tip in the middle; M
 * is 150 mm long, K 125, P 170, Q 180, R 200. Bars: shank diameter and f, the distance of the tip from the bar axis.
 * The head stays 1 mm inside the edges of its insert and runs back to the shank.
 */

/** PDJNR 2525M15: 93°, f 32. `seat` are the two corners under the edges, `top` the one at the end of the main edge. */
const pdjnr = (seat: readonly [Corner, Corner], top: Corner): Holder =>
  holder({ width: 25, length: 114, z: 7, x: 36 }, [...seat, [32, 22], [32, 36], [7, 36], top]);

/** The holder of each shipped tool, by its number. */
export const shippedHolders: Readonly<Record<number, Holder>> = {
  // PCLNR 2525M12: 95°, f 32.
  1: holder({ width: 25, length: 122, z: 7, x: 28 }, [
    [1, 1],
    [11, 1.9],
    [32, 10],
    [32, 28],
    [7, 28],
    [1.9, 11],
  ]),
  2: pdjnr(
    [
      [1, 1.2],
      [9.1, 6.2],
    ],
    [1.5, 10.7],
  ),
  3: pdjnr(
    [
      [1.1, 1.5],
      [9.2, 6.6],
    ],
    [1.6, 11.1],
  ),
  // SVJBR 2525M16: 93°, f 32.
  4: holder({ width: 25, length: 107, z: 7, x: 43 }, [
    [1.1, 2.3],
    [8.8, 12.1],
    [32, 43],
    [7, 43],
    [1.8, 14.8],
  ]),
  // A20Q-SCLCR 09: bar of 20 mm, f 13, for bores from 25 mm.
  5: holder({ width: 20, length: 160, z: 20, x: -3 }, [
    [1.1, -1.1],
    [8, -1.7],
    [20, -3],
    [20, -23],
    [8, -23],
    [3, -17],
    [1.7, -8],
  ]),
  // A20Q-SDUCR 11: bar of 20 mm, f 13, for bores from 25 mm.
  6: holder({ width: 20, length: 168, z: 12, x: -3 }, [
    [1.1, -1.5],
    [6.6, -5],
    [12, -8.5],
    [12, -23],
    [8, -23],
    [3, -17],
    [1.4, -8.1],
  ]),
  // PDJNL 2525M15: the mirror image of the holder of tool 2.
  7: holder({ width: 25, length: 114, z: -7, x: 36 }, [
    [-1, 1.2],
    [-9.1, 6.2],
    [-32, 22],
    [-32, 36],
    [-7, 36],
    [-1.5, 10.7],
  ]),
  // Axial blade of 2.4 mm in a shank 25×25 that lies along Z; its curvature is left out.
  8: holder({ width: 25, length: 115, z: 35, x: -1.2 }, [
    [1.5, -1.2],
    [35, -1.2],
    [35, 1.2],
    [1.5, 1.2],
  ]),
  // Radial blade of 2.4 mm, flush with the −Z side of a shank 25×25.
  9: holder({ width: 25, length: 120, z: -1.2, x: 30 }, blade(1.2, 30, 1)),
  // Radial blade of 1.6 mm, flush with the −Z side of a shank 20×20.
  10: holder({ width: 20, length: 105, z: -0.8, x: 20 }, blade(0.8, 20, 1)),
  // SRDCN 2020K06: neutral, a neck narrower than the insert, then the shoulders of the shank.
  11: holder(
    { width: 20, length: 105, z: -10, x: 20 },
    [
      [-1.5, 1.2],
      [1.5, 1.2],
      [2.2, 3],
      [2.2, 14],
      [-2.2, 14],
      [-2.2, 3],
    ],
    [
      [-2.2, 14],
      [2.2, 14],
      [10, 20],
      [-10, 20],
    ],
  ),
  // SER 2525M16: f 32. Above the tooth the insert counts as holder; its leading side is flush with the tooth, as for
  // threads to a shoulder.
  12: holder({ width: 25, length: 116, z: 7, x: 34 }, [
    [-1.4, 2.5],
    [1.4, 2.5],
    [4.3, 9.3],
    [32, 24],
    [32, 34],
    [7, 34],
    [-1.4, 14],
  ]),
  // SIR 0020P16: bar of 20 mm, f 14, for bores from 25 mm, its end flush with the tooth.
  13: holder({ width: 20, length: 170, z: -1.4, x: -4 }, [
    [-1.4, -2.5],
    [1.4, -2.5],
    [4.3, -9.3],
    [-1.4, -9.3],
  ]),
  // Grooving bar of 25 mm with a blade of 1.6 mm, 12 mm high.
  14: holder({ width: 25, length: 200, z: -0.8, x: -12 }, blade(0.8, 12, -1)),
  // PDJNL 2525M15 laid along Z for facing: f 32 from the tip in X.
  15: holder({ width: 25, length: 114, z: 36, x: 7, axis: "Z" }, [
    [1.2, 1],
    [10.7, 1.9],
    [36, 7],
    [36, 32],
    [20.5, 32],
    [5.9, 9.3],
  ]),
};
