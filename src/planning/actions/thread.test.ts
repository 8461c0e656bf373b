import { expect, test } from "vitest";
import { at, part as geometry, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { degrees, length } from "../../kernel/units.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { readThread } from "../../kernel/thread/threads.ts";
import { threadEnd } from "./thread.ts";

const [PITCH, CREST, ROOT, NOSE, TOOTH] = [2, 8, 6.6, 0.1, 2.5];
const tool: Tool = {
  T: 1,
  NAME: "THREAD",
  TYPE: "THREAD",
  TO: 2,
  RS: length(NOSE),
  "P-ANGLE": degrees(60),
  CUTLENGTH: length(TOOTH),
};
const named = readThread("M16");
if (!named) throw new Error("M16");

const lines = (...points: readonly Pt[]): Segment[] =>
  points.slice(1).map((to, i) => geometry.line(points[i] ?? to, to));
const thread = lines(at(0, CREST), at(-24, CREST));
const hollow = (from: Pt, to: Pt): Segment => ({ kind: "arc", from, to, centre: at(from.z, to.r), turn: "cw" });
const rounding = hollow(at(-24, CREST), at(-25, CREST + 1));
/** What is behind a thread on the outside. */
const BEHIND: readonly (readonly [string, readonly Segment[]])[] = [
  ["a shoulder", lines(at(-24, CREST), at(-24, 12), at(-40, 12))],
  ["a low shoulder", lines(at(-24, CREST), at(-24, 8.5), at(-40, 8.5))],
  ["a rounding at the foot", [rounding, ...lines(at(-25, CREST + 1), at(-25, 12), at(-40, 12))]],
  ["a chamfer at the foot", lines(at(-24, CREST), at(-25, CREST + 1), at(-25, 12), at(-40, 12))],
  ["a flat cone", lines(at(-24, CREST), at(-34, 12))],
  ["a steep cone", lines(at(-24, CREST), at(-25, 12))],
  ["a shoulder that leans over its foot", lines(at(-24, CREST), at(-22.5, 12), at(-40, 12))],
  [
    "a shallow relief with a rounding",
    [
      ...lines(at(-24, CREST), at(-24.5, 7.8), at(-26, 7.8)),
      hollow(at(-26, 7.8), at(-27, 8.8)),
      ...lines(at(-27, 8.8), at(-27, 12)),
    ],
  ],
];

const inside = ({ from, to }: Segment): Segment => geometry.line(at(from.z, 20 - from.r), at(to.z, 20 - to.r));

test.each(
  BEHIND.flatMap(([name, behind]) => [
    ["outside", name, behind] as const,
    ...(behind.some(({ kind }) => kind === "arc") ? [] : [["inside", name, behind] as const]),
  ]),
)("%s, in front of %s, the tooth comes as near as a pitch and no nearer", (site, _, behind) => {
  const all = [...thread, ...behind];
  const chain = { segments: site === "outside" ? all : all.map(inside), marks: [] };
  const place = { first: 0, last: 0, designation: "M16" };
  const { end } = threadEnd(named, place, { chain, site, root: site === "outside" ? ROOT : 20 - ROOT, tool });
  // Along Z from the flank to the contour, at many heights of the shoulder.
  const room = behind.flatMap((segment) =>
    Array.from({ length: 401 }, (__, i) => geometry.pointOn(segment, i / 400)).flatMap(({ z, r }) =>
      r > CREST + 1e-6 ? [end - Math.tan(Math.PI / 6) * Math.min(TOOTH, r - ROOT) - NOSE - z] : [],
    ),
  );
  expect(Math.min(...room)).toBeGreaterThan(PITCH - 0.001);
  expect(Math.min(...room)).toBeLessThan(PITCH + 0.02);
});
