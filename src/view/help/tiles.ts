import type { Place, Size } from "../camera.ts";
import type { HelpFrame } from "./frame.ts";
import { arrowHead, polygon, polyline, type Fill, type Line, type Mark } from "./marks.ts";
import { filled, stroke, value, type Tag } from "./stroke.ts";
import type { Topic } from "../../cycles/params.ts";

/** A point of a small diagram: u with the cutting feed, v away from the material, both 0 … 1. */
type Spot = readonly [u: number, v: number];
type Stroke =
  | { readonly line: Line; readonly at: readonly Spot[]; readonly arrow?: true }
  | { readonly fill: Fill; readonly at: readonly Spot[] };

/** One diagram and its drawing area, pixels. */
const TILE = { width: 62, height: 50, least: 42, gap: 8, top: 2 } as const;
/** Height of the row that holds the diagrams. */
export const TILE_ROW = TILE.height + 8;
/** How many diagrams fit into a column of a height, how tall each is, and how wide all columns are, pixels. */
export function columnsFor(
  count: number,
  height: number,
): { readonly each: number; readonly width: number; readonly tall: number } {
  const room = height - 4 + TILE.gap;
  const most = Math.max(1, Math.floor(room / (TILE.least + TILE.gap)));
  const columns = Math.ceil(count / most);
  const each = Math.ceil(count / columns);
  return {
    each,
    width: columns * (TILE.width + TILE.gap),
    tall: Math.max(TILE.least, Math.min(TILE.height, Math.floor(room / each) - TILE.gap)),
  };
}

const STEP: readonly Spot[] = [
  [0, 0.22],
  [0.58, 0.22],
  [0.8, 0.8],
  [1, 0.8],
];
const VALLEY: readonly Spot[] = [
  [0, 0.75],
  [0.2, 0.75],
  [0.36, 0.25],
  [0.64, 0.25],
  [0.8, 0.75],
  [1, 0.75],
];
const below = (line: readonly Spot[]): Stroke => ({ fill: "part", at: [...line, [1, 0], [0, 0]] });
const drawn = (line: readonly Spot[]): Stroke[] => [below(line), { line: "contour", at: line }];
const raised = (line: readonly Spot[], by: number): Spot[] => line.map(([u, v]) => [u - by * 0.5, v + by]);
const pass = (v: number): Stroke => ({
  line: "pass",
  at: [
    [0, v],
    [0.58 + (v - 0.22) * 0.38, v],
  ],
});
const cut: Stroke = { fill: "cut", at: [...STEP, [0, 0.8]] };
const stock: Stroke[] = [cut, pass(0.42), pass(0.61)];
const way = (at: readonly Spot[]): Stroke => ({ line: "path", at, arrow: true });

/** A groove with upright walls, an insert in it, and the way of a plunge that begins at `u`. */
const SLOT: readonly Spot[] = [
  [0, 0.75],
  [0.12, 0.75],
  [0.12, 0.15],
  [0.88, 0.15],
  [0.88, 0.75],
  [1, 0.75],
];
const insert = (u: number, v: number): Stroke => ({
  fill: "tool",
  at: [
    [u, v],
    [u + 0.2, v],
    [u + 0.2, v + 0.3],
    [u, v + 0.3],
  ],
});
const plunge = (u: number): Stroke =>
  way([
    [u + 0.1, 0.98],
    [u + 0.1, 0.2],
  ]);

const corner = (kind: 0 | 1 | 2): Stroke[] => {
  const round: Spot[] = Array.from(
    { length: 7 },
    (_, i) => [0.5 - 0.3 * Math.sin((i * Math.PI) / 12), 0.35 + 0.3 * Math.cos((i * Math.PI) / 12)] as const,
  );
  const at: readonly (readonly Spot[])[] = [
    [[0.2, 0.65]],
    [
      [0.2, 0.35],
      [0.5, 0.65],
    ],
    [...round].reverse(),
  ];
  const line: Spot[] = [[0.2, 0], ...(at[kind] ?? []), [1, 0.65]];
  return [
    { fill: "part", at: [...line, [1, 0]] },
    { line: "contour", at: line },
  ];
};

/** Lines beside a hill, at these distances from it. */
const HILL: readonly Spot[] = [
  [0, 0.1],
  [0.3, 0.1],
  [0.5, 0.4],
  [0.7, 0.1],
  [1, 0.1],
];
const thinner = (distances: readonly number[]): Stroke[] => [
  ...drawn(HILL),
  ...distances.map((d): Stroke => ({ line: "pass", at: HILL.map(([u, v]): Spot => [u, v + d]) })),
];

const TEETH: readonly number[] = [0, 1, 2, 3, 4];
/** Teeth along u whose crests stand at one height and their roots at another. */
const toothed = (crest: number, root: number, from = 0.08, to = 0.92): Spot[] => {
  const each = (to - from) / TEETH.length;
  return TEETH.flatMap((i): Spot[] => [
    [from + each * i, crest],
    [from + each * (i + 0.5), root],
  ]).concat([[to, crest]]);
};
/** The material between a toothed line and another height. */
const threaded = (line: readonly Spot[], to: number): Stroke[] => [
  { fill: "part", at: [...line, [line.at(-1)?.[0] ?? 1, to], [line[0]?.[0] ?? 0, to]] },
  { line: "contour", at: line },
];
const AXIS: Stroke = {
  line: "break",
  at: [
    [0, 0.5],
    [1, 0.5],
  ],
};

const SLOPE: readonly Spot[] = [
  [0.15, 0.3],
  [0.85, 0.68],
];
const known = ([u, v]: Spot): Stroke => ({
  fill: "arrow",
  at: [
    [u - 0.06, v - 0.07],
    [u + 0.06, v - 0.07],
    [u + 0.06, v + 0.07],
    [u - 0.06, v + 0.07],
  ],
});
/** A line with a known point, the angle, and the height or the place of the other point. */
const tapered = (at: "start" | "end", other: "height" | "place"): Stroke[] => {
  const [a, b] = SLOPE as [Spot, Spot];
  const [point, open] = at === "start" ? [a, b] : [b, a];
  const given: readonly Spot[] =
    other === "height"
      ? [
          [0.02, open[1]],
          [0.98, open[1]],
        ]
      : [
          [open[0], 0.02],
          [open[0], 0.98],
        ];
  return [
    { line: "limit", at: given },
    { line: "contour", at: SLOPE },
    { line: "break", at: [a, [0.85, a[1]]] },
    known(point),
  ];
};
/** A groove with the levels of its passes. */
const groove = (levels: readonly number[]): Stroke[] => [
  ...drawn([
    [0, 0.85],
    [0.14, 0.85],
    [0.5, 0.1],
    [0.86, 0.85],
    [1, 0.85],
  ]),
  ...levels.map((v): Stroke => ({
    line: "pass",
    at: [
      [0.5 - (v - 0.1) * 0.48, v],
      [0.5 + (v - 0.1) * 0.48, v],
    ],
  })),
];

/** The diagrams of each choice, by its value. */
const diagrams: Readonly<Partial<Record<Topic, readonly (readonly Stroke[])[]>>> = {
  operation: [
    [...stock, ...drawn(STEP), way(raised(STEP, 0.1))],
    [...stock, ...drawn(raised(STEP, 0.1)).slice(1), ...drawn(STEP)],
    [...drawn(STEP), way(raised(STEP, 0.1))],
    [...drawn(STEP), { line: "break", at: raised(STEP, 0.1) }, way(raised(STEP, 0.2))],
  ],
  smoothing: [
    [
      ...drawn(STEP),
      pass(0.72),
      way([
        [0, 0.45],
        [0.65, 0.45],
        [0.74, 0.7],
        [0.74, 0.95],
      ]),
    ],
    [
      ...drawn(STEP),
      pass(0.72),
      way([
        [0, 0.45],
        [0.62, 0.45],
        [0.42, 0.75],
      ]),
      way(raised(STEP, 0.09)),
    ],
    [
      below([
        [0, 0.22],
        [0.58, 0.22],
        [0.58, 0.45],
        [0.67, 0.45],
        [0.67, 0.8],
        [1, 0.8],
      ]),
      {
        line: "contour",
        at: [
          [0, 0.22],
          [0.58, 0.22],
          [0.58, 0.45],
          [0.67, 0.45],
          [0.67, 0.8],
          [1, 0.8],
        ],
      },
      way([
        [0, 0.48],
        [0.64, 0.48],
        [0.44, 0.78],
      ]),
    ],
  ],
  plunging: [
    [
      ...drawn(VALLEY),
      {
        fill: "cut",
        at: [
          [0.2, 0.75],
          [0.36, 0.25],
          [0.64, 0.25],
          [0.8, 0.75],
        ],
      },
      way([
        [0, 0.82],
        [1, 0.82],
      ]),
    ],
    [
      ...drawn(VALLEY),
      way([
        [0, 0.82],
        [0.22, 0.82],
        [0.4, 0.34],
        [0.62, 0.34],
        [0.78, 0.84],
        [1, 0.84],
      ]),
    ],
  ],
  reverse: [
    [...drawn(STEP), way(raised(STEP, 0.12))],
    [...drawn(STEP), way([...raised(STEP, 0.12)].reverse())],
    [
      ...drawn(STEP),
      way([...raised(STEP, 0.12)].reverse()),
      {
        fill: "tool",
        at: [
          [0.28, 0.4],
          [0.2, 0.9],
          [0.42, 0.95],
          [0.5, 0.55],
        ],
      },
    ],
  ],
  limits: [
    [...stock, ...drawn(STEP)],
    [
      {
        fill: "cut",
        at: [
          [0, 0.22],
          [0.4, 0.22],
          [0.4, 0.8],
          [0, 0.8],
        ],
      },
      ...drawn(STEP),
      {
        line: "limit",
        at: [
          [0.4, 0],
          [0.4, 1],
        ],
      },
    ],
  ],
  direction: [
    [
      ...drawn(VALLEY),
      way([
        [0.28, 0.62],
        [0.74, 0.62],
      ]),
      way([
        [0.68, 0.42],
        [0.32, 0.42],
      ]),
    ],
    [
      ...drawn(VALLEY),
      way([
        [0.28, 0.62],
        [0.74, 0.62],
      ]),
      way([
        [0.32, 0.42],
        [0.68, 0.42],
      ]),
    ],
  ],
  cuttingLines: [thinner([0.08, 0.18, 0.3, 0.46]), thinner([0.12, 0.23, 0.35, 0.46])],
  element: [corner(0), corner(1), corner(2)],
  threadPosition: [
    [AXIS, ...threaded(toothed(0.85, 0.7), 0.5), ...threaded(toothed(0.15, 0.3), 0.5)],
    [AXIS, ...threaded(toothed(0.7, 0.85), 1), ...threaded(toothed(0.3, 0.15), 0)],
  ],
  threadOrientation: [
    [
      ...threaded(toothed(0.6, 0.4), 0.05),
      {
        line: "break",
        at: [
          [0, 0.05],
          [1, 0.05],
        ],
      },
    ],
    [
      ...threaded(toothed(0.6, 0.4, 0.2, 0.95), 0.05),
      {
        line: "break",
        at: [
          [0.1, 0],
          [0.1, 1],
        ],
      },
    ],
  ],
  taperForm: [
    [{ line: "contour", at: SLOPE }, known([0.15, 0.3]), known([0.85, 0.68])],
    tapered("end", "height"),
    tapered("end", "place"),
    tapered("start", "height"),
    tapered("start", "place"),
  ],
  infeedType: [groove([0.53, 0.397, 0.295, 0.209]), groove([0.7, 0.55, 0.4, 0.25])],
  retraction: [
    [
      ...drawn(SLOT),
      insert(0.3, 0.2),
      way([
        [0.4, 0.2],
        [0.4, 0.95],
      ]),
    ],
    [
      ...drawn(SLOT),
      insert(0.3, 0.2),
      way([
        [0.4, 0.2],
        [0.62, 0.42],
        [0.62, 0.95],
      ]),
    ],
  ],
  comb: [
    [...drawn(SLOT), ...[0.2, 0.36, 0.52, 0.68].map((u) => plunge(u))],
    [
      ...drawn(SLOT),
      {
        fill: "cut",
        at: [
          [0.34, 0.2],
          [0.44, 0.2],
          [0.44, 0.75],
          [0.34, 0.75],
        ],
      },
      {
        fill: "cut",
        at: [
          [0.58, 0.2],
          [0.68, 0.2],
          [0.68, 0.75],
          [0.58, 0.75],
        ],
      },
      ...[0.15, 0.39, 0.63].map((u) => plunge(u)),
    ],
  ],
};

/** Whether a choice has small diagrams. */
export const hasTiles = (topic: Topic): boolean => diagrams[topic] !== undefined;

/**
 * Small diagrams in a row at the foot of the picture or in columns at its left, read line by line, one for each value;
 * the chosen one strong.
 */
export function tiles(
  f: HelpFrame,
  topic: Topic,
  choices: readonly number[],
  tag: { readonly q: string; readonly chosen: number | null },
  size: Size,
  column: boolean,
): Mark[] {
  const width = column
    ? TILE.width
    : Math.min(TILE.width, (size.width - 8 - TILE.gap * (choices.length - 1)) / choices.length);
  const { each, tall: high } = columnsFor(choices.length, size.height);
  const across = Math.ceil(choices.length / each);
  const tall = column ? high : TILE.height;
  const whole = choices.length * width + (choices.length - 1) * TILE.gap;
  const marks = choices.flatMap((choice, i) => {
    const own: Tag = { q: tag.q, active: choice === tag.chosen };
    const left = column
      ? 4 + (i % across) * (TILE.width + TILE.gap)
      : (size.width - whole) / 2 + i * (width + TILE.gap);
    const top = column
      ? (size.height - each * (tall + TILE.gap) + TILE.gap) / 2 + Math.floor(i / across) * (tall + TILE.gap)
      : size.height - TILE_ROW + TILE.top;
    const inner = { x: left + 14, y: top + 4, width: width - 18, height: tall - 8 };
    const place = ([u, v]: Spot): Place => {
      const [along, up] = !f.transverse
        ? [f.signU < 0 ? 1 - u : u, f.signV > 0 ? v : 1 - v]
        : [f.signV > 0 ? v : 1 - v, f.signU < 0 ? 1 - u : u];
      return { x: inner.x + along * inner.width, y: inner.y + (1 - up) * inner.height };
    };
    const edge = polygon([
      { x: left, y: top },
      { x: left + width, y: top },
      { x: left + width, y: top + tall },
      {
        x: left,
        y: top + tall,
      },
    ]);
    const drawing = (diagrams[topic]?.[choice] ?? []).flatMap((s): Mark[] => {
      const places = s.at.map(place);
      if ("fill" in s) return [filled(own, s.fill, polygon(places))];
      const [a, b] = [places.at(-2), places.at(-1)];
      const head = s.arrow && a && b ? [filled(own, "arrow", arrowHead(b, b.x - a.x, b.y - a.y, 6))] : [];
      return [stroke(own, s.line, polyline(places)), ...head];
    });
    return [
      filled(own, "paper", edge),
      stroke(own, "frame", edge),
      ...drawing,
      value(own, { x: left + 8, y: top + 11 }, String(choice)),
    ];
  });
  return marks;
}
