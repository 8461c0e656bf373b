import { centreDepth, centreDrill, centreProfile, mouthAt } from "../../src/kernel/cutter/centre-drill.ts";
import { at, part, type Pt, type Ring } from "../../src/kernel/geometry/point.ts";
import { cutThread } from "../../src/kernel/thread/named-thread.ts";
import { readThread } from "../../src/kernel/thread/threads.ts";
import { radians, radius, radiusOf, toDiameter } from "../../src/kernel/units.ts";
import type { Chain, PlannedPart } from "../../src/planning/types.ts";

/** A corner as Z and ⌀, mm. */
type Corner = readonly [z: number, across: number];

/** A part with a bore, and the stock that it is turned from. */
export interface BorePart {
  readonly part: PlannedPart;
  readonly blank: readonly Ring[];
  /** Threads that are made, by their designation. */
  readonly threads: readonly string[];
}

const pointOf = ([z, across]: Corner): Pt => at(z, radiusOf(across));

function chainOf(points: readonly Pt[], threads: Readonly<Record<number, string>> = {}): Chain {
  const segments = points.slice(1).map((to, i) => part.line(points[i] ?? to, to));
  return {
    segments,
    marks: segments.map((_, i) => ({ row: `e${i}`, ...(threads[i] !== undefined && { thread: threads[i] }) })),
  };
}

/** A part from its outside, ending at the outer edge of its rear face, and its bore; `threads` by element of the bore. */
function borePart(
  name: string,
  outside: readonly Corner[],
  inside: readonly Corner[],
  { behind = 30, threads = {} }: { readonly behind?: number; readonly threads?: Readonly<Record<number, string>> } = {},
): BorePart {
  const [outer, inner] = [outside.map(pointOf), inside.map(pointOf)];
  const [rear, bottom] = [outer.at(-1) ?? at(0, 0), inner.at(-1) ?? at(0, 0)];
  const core = bottom.r === 0 ? [at(rear.z, 0)] : [];
  const high = Math.max(...outer.map(({ r }) => r)) + 1;
  const left = rear.z - behind;
  return {
    part: {
      name,
      outside: chainOf(outer),
      inside: chainOf(inner, threads),
      rings: [[...outer, ...core, ...inner.toReversed()]],
    },
    blank: [[at(left, 0), at(1, 0), at(1, high), at(left, high)]],
    threads: Object.values(threads),
  };
}

/** ⌀ of the bore before an internal thread, in the middle of its class. */
function crestOf(name: string): number {
  const side = readThread(name)?.inside;
  if (!side) throw new Error(`no internal thread ${name}`);
  return cutThread(side, "middle").crest;
}

/** Point of a drill below a ⌀. */
const pointBelow = (across: number) => radiusOf(across) / Math.tan(radians(118) / 2);

/** The centre hole of a drill with a pilot, from the face to its point. */
function centreHole(name: string, pilot: number): readonly Corner[] {
  const drill = centreDrill(name, pilot);
  if (!drill) throw new Error(`no ${name}`);
  const depth = centreDepth(drill);
  const below = centreProfile(drill, 5).filter(({ u }) => u < depth);
  return [
    [0, mouthAt(drill, 5, depth)],
    ...below.toReversed().map(({ u, v }): Corner => [u - depth, toDiameter(radius(v))]),
  ];
}

const [m10, m12, m24, m30] = [crestOf("M10"), crestOf("M12"), crestOf("M24x1.5"), crestOf("M30x1.5")];
const cylinder = (across: number, from: number, rear: number): readonly Corner[] => [
  [0, from],
  [0, across],
  [rear, across],
];

/** Parts with bores of every kind: through, stepped, blind, conical, grooved, threaded, tapped, a centre hole. */
export const boreParts: readonly BorePart[] = [
  borePart(
    "bush",
    [
      [0, 32],
      [0, 48],
      [-1, 50],
      [-40, 50],
    ],
    [
      [0, 32],
      [-1, 30],
      [-40, 30],
    ],
  ),
  borePart("blind", cylinder(50, 30, -60), [
    [0, 30],
    [-15, 30],
    [-15, 24],
    [-35, 24],
    [-35, 0],
  ]),
  borePart("stepped", cylinder(60, 40, -50), [
    [0, 40],
    [-12, 40],
    [-12, 28],
    [-30, 28],
    [-30, 18],
    [-50, 18],
  ]),
  borePart("cones", cylinder(45, 36, -70), [
    [0, 36],
    [-30, 20],
    [-50, 16],
    [-70, 16],
  ]),
  borePart("groove", cylinder(50, 30, -45), [
    [0, 30],
    [-15, 30],
    [-15, 36],
    [-20, 36],
    [-20, 30],
    [-45, 30],
  ]),
  borePart(
    "nut",
    cylinder(30, m10 + 3, -20),
    [
      [0, m10 + 3],
      [-1.5, m10],
      [-20, m10],
    ],
    { threads: { 1: "M10" } },
  ),
  borePart("long", cylinder(30, 8.5, -50), [
    [0, 8.5],
    [-50, 8.5],
  ]),
  borePart(
    "tapped",
    cylinder(30, m12, -50),
    [
      [0, m12],
      [-20, m12],
      [-24, m12],
      [-24 - pointBelow(m12), 0],
    ],
    { threads: { 0: "M12" } },
  ),
  borePart(
    "sleeve",
    cylinder(45, 27, -36),
    [
      [0, 27],
      [-2, m24],
      [-36, m24],
    ],
    { threads: { 1: "M24x1.5" } },
  ),
  borePart(
    "relieved",
    cylinder(50, 33, -60),
    [
      [0, 33],
      [-2, m30],
      [-20, m30],
      [-20, 31],
      [-25, 31],
      [-25, 20],
      [-40, 20],
      [-40 - pointBelow(20), 0],
    ],
    { threads: { 1: "M30x1.5" } },
  ),
  borePart("centred", cylinder(30, 8.5, -50), centreHole("A4", 5)),
  // The rear has a shoulder and a counterbore that only the second clamping reaches.
  borePart(
    "bothEnds",
    [
      [0, 32],
      [0, 40],
      [-25, 40],
      [-25, 56],
      [-40, 56],
      [-40, 46],
      [-55, 46],
    ],
    [
      [0, 32],
      [-30, 32],
      [-30, 24],
      [-40, 24],
      [-40, 34],
      [-55, 34],
    ],
    { behind: 1 },
  ),
];
