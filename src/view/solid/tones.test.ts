import { expect, test } from "vitest";
import { at } from "../../kernel/geometry/point.ts";
import type { FormedBy, RoughStretch } from "../../sim/load/roughness.ts";
import { tonedSides } from "./tones.ts";

/** From 0 to 7 µm, one tone for each micrometre. */
const scale = { bounds: [0, 1, 2, 3, 4, 5, 6, 7] };
const stretch = (
  rz: number | null,
  points: readonly (readonly [z: number, r: number])[],
  by: FormedBy = "nose",
): RoughStretch => ({
  points: points.map(([z, r]) => at(z, r)),
  position: { step: 3, fraction: 0.5 },
  block: 7,
  operation: 0,
  by,
  rz,
  exact: rz,
  feed: 0.17,
  nose: 0.8,
});
const flank = (z: number) =>
    stretch(
      null,
      [
        [z, 9],
        [z - 0.7, 9.6],
      ],
      "thread",
    ),
  land = (z: number) =>
    stretch(2.2, [
      [z, 9.6],
      [z - 0.3, 9.6],
    ]);

type Row = readonly [z0: number, r0: number, z1: number, r1: number, tone: number];
const cases: readonly (readonly [string, readonly RoughStretch[], readonly Row[]])[] = [
  [
    "pieces of one line are one side",
    [
      stretch(2.2, [
        [0, 7.3],
        [-1.1, 7.3],
        [-2.9, 7.3],
        [-5.7, 7.3],
      ]),
    ],
    [[0, 7.3, -5.7, 7.3, 2]],
  ],
  [
    "also of a cone",
    [
      stretch(5.1, [
        [0, 7],
        [-1.1, 7.22],
        [-3.3, 7.66],
      ]),
    ],
    [[0, 7, -3.3, 7.66, 5]],
  ],
  [
    "a corner parts them",
    [
      stretch(5.1, [
        [0, 7],
        [-1.1, 7],
        [-1.1, 9.4],
      ]),
    ],
    [
      [0, 7, -1.1, 7, 5],
      [-1.1, 7, -1.1, 9.4, 5],
    ],
  ],
  [
    "so does a gap",
    [
      stretch(1, [
        [0, 7],
        [-1, 7],
      ]),
      stretch(1, [
        [-1.4, 7],
        [-2, 7],
      ]),
    ],
    [
      [0, 7, -1, 7, 1],
      [-1.4, 7, -2, 7, 1],
    ],
  ],
  [
    "and so does a change of direction",
    [
      stretch(1, [
        [0, 7],
        [-1, 7],
        [-0.4, 7],
      ]),
    ],
    [
      [0, 7, -1, 7, 1],
      [-1, 7, -0.4, 7, 1],
    ],
  ],
  [
    "and another tone",
    [
      stretch(1.9, [
        [0, 7],
        [-1, 7],
      ]),
      stretch(6.3, [
        [-1, 7],
        [-2, 7],
      ]),
    ],
    [
      [0, 7, -1, 7, 1],
      [-1, 7, -2, 7, 6],
    ],
  ],
  [
    "other values of a class do not",
    [
      stretch(1.2, [
        [0, 7],
        [-1, 7],
      ]),
      stretch(1.9, [
        [-1, 7],
        [-2, 7],
      ]),
    ],
    [[0, 7, -2, 7, 1]],
  ],
  [
    "a stretch without a value has none",
    [
      stretch(null, [
        [0, 7],
        [-1, 7],
      ]),
    ],
    [],
  ],
  [
    "the flats between flanks of a thread have none, the cylinder beside it has",
    [land(0), flank(-1), land(-2), flank(-3), land(-4)],
    [
      [0, 9.6, -0.3, 9.6, 2],
      [-4, 9.6, -4.3, 9.6, 2],
    ],
  ],
];

test.each(cases)("%s", (_, stretches, sides) => {
  expect(tonedSides(stretches, scale).map(({ z0, r0, z1, r1, tone }) => [z0, r0, z1, r1, tone])).toEqual(sides);
});
