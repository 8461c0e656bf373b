import { readFileSync } from "node:fs";
import { describe, expect, test } from "vitest";
import { areaOf } from "../../kernel/area/area.ts";
import { difference, union } from "../../kernel/area/clip.ts";
import { insertOutline } from "../../kernel/cutter/insert.ts";
import { at, type Ring } from "../../kernel/geometry/point.ts";
import { CHORD } from "../../kernel/tolerance.ts";
import { degrees } from "../../kernel/units.ts";
import { parse } from "../../nc/parse.ts";
import { run } from "../../program/run/run.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { simulate } from "../../sim/simulate.ts";
import { turnsBack } from "../../sim/load/spindles.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import { playerOf } from "../../sim/stock.ts";
import { sweptBy } from "../../sim/sweep.ts";
import { volumeOf, type Mesh } from "./mesh.ts";
import { wholeMesh } from "./revolve.ts";
import { runThreads } from "./thread-cuts.ts";
import { threaded, type ThreadTurning } from "./threaded.ts";

function made(name: string, change: (text: string) => string = (text) => text) {
  const text = change(readFileSync(`tests/programs/${name}.h`, "utf8"));
  const ran = run(parse(text), { tools: shippedTools, rapid: 8000 });
  const { blank, stated, steps, operations, unproved } = ran;
  const player = playerOf(simulate({ blank, stated, steps, operations, unproved }));
  const threads = runThreads(steps, player.at, { spindles: ran.spindles });
  return {
    steps,
    spindles: ran.spindles,
    player,
    at: (now: PlayPosition) => ({ stock: player.at(now), apart: threads?.of(player.at(now), now) ?? null }),
  };
}
type Made = ReturnType<typeof made>;
const finished = ({ steps }: Made): PlayPosition => ({ step: steps.length, fraction: 0 });

/**
 * The half plane that lies a share of a turn farther over the operator, cut by the same moves begun at another angle of
 * the spindle.
 */
function sectionAt({ steps, spindles }: Made, base: readonly Ring[], now: PlayPosition, share: number): Ring[] {
  const cuts = steps.flatMap((step, i) => {
    const { move } = step;
    if (move.kind !== "thread" || i > now.step) return [];
    // Seen from the headstock M3 turns the work clockwise: over the operator, back and round.
    const angle = degrees(move.angle + 360 * share * (turnsBack(spindles, i) ? -1 : 1));
    return [
      ...sweptBy(
        insertOutline(step.tool, CHORD),
        { ...step, move: { ...move, angle } },
        i < now.step ? 1 : now.fraction,
      ).rings,
    ];
  });
  return difference(base, union(cuts));
}

/** 2π · area · distance of the centroid of rings, exact for polygons. */
const volumeTurned = (rings: readonly Ring[]) =>
  rings.reduce(
    (sum, ring) =>
      sum +
      ring.reduce((s, p, i) => {
        const q = ring[(i + 1) % ring.length] ?? p;
        return s + (p.z * q.r - q.z * p.r) * (p.r + q.r);
      }, 0),
    0,
  ) *
  (Math.PI / 3);

/** How many edges are run through more often in one direction, and how many do not have two triangles. */
function openEdges({ positions: p, index }: Mesh) {
  const book = new Map<string, { sum: number; count: number }>(),
    name = (i: number) => [0, 1, 2].map((k) => p[3 * i + k]).join(" ");
  for (let t = 0; t < index.length; t += 3)
    for (let k = 0; k < 3; k += 1) {
      const [a, b] = [name(index[t + k] ?? -1), name(index[t + ((k + 1) % 3)] ?? -1)],
        key = a < b ? `${a}|${b}` : `${b}|${a}`;
      const entry = book.get(key) ?? { sum: 0, count: 0 };
      book.set(key, { sum: entry.sum + (a < b ? 1 : -1), count: entry.count + 1 });
    }
  const all = [...book.values()];
  return { open: all.filter(({ sum }) => sum !== 0).length, crowded: all.filter(({ count }) => count !== 2).length };
}

const fine: ThreadTurning = { chords: 64, quarterCut: false, hand: 1, within: 0.01, most: 400_000 };

/** The face of the cut that lies towards the operator, put together from its triangles. */
function lying({ positions, normals, index }: Mesh): Ring[] {
  const rings: Ring[] = [];
  for (let t = 0; t < index.length; t += 3) {
    if (normals[3 * (index[t] ?? 0)] !== 1) continue;
    const ring = [0, 1, 2]
      .map((k) => 3 * (index[t + k] ?? 0))
      .map((i) => at(positions[i + 2] ?? 0, positions[i + 1] ?? 0));
    if (areaOf([ring]) !== 0) rings.push(areaOf([ring]) > 0 ? ring : ring.reverse());
  }
  return union(rings);
}

const call = readFileSync("tests/programs/cycle-831.h", "utf8").split("\n").slice(7, 23);
/** A second thread behind the first one: finer, and in the same blank. */
const second = call.map((line) =>
  line
    .replace(/(Q492=).*? ;/, "$1-36.1 ;")
    .replace(/(Q494=).*? ;/, "$1-51.7 ;")
    .replace(/(Q472=).*? ;/, "$1+1.75 ;")
    .replace(/Z\+8.1/, "Z-31.7")
    .replace(/(Q460=).*? ;/, "$1+2 ;"),
);
const works: readonly (readonly [what: string, work: Made, moment: (work: Made) => PlayPosition])[] = [
  ["a thread that runs out", made("cycle-831"), finished],
  ["a conical thread with a run-out", made("cycle-830"), finished],
  ["a thread of two starts in a bore", made("cycle-832"), finished],
  [
    "a thread in the middle of a pass",
    made("cycle-831"),
    ({ steps }) => ({
      step: steps.findLastIndex(({ move }) => move.kind === "thread" && move.phase === "thread" && !move.stops),
      fraction: 0.437,
    }),
  ],
  [
    "a left-handed thread: the spindle turns backwards",
    made("cycle-831", (text) => text.replace("M303", "M304")),
    finished,
  ],
  ["threads of two leads", made("cycle-831", (text) => text.replace("10 L", `${second.join("\n")}\n10 L`)), finished],
  [
    "threads of both hands",
    made("cycle-831", (text) =>
      text.replace("10 L", `${second.join("\n").replace("M303", "M304").replace("Q472=+1.75", "Q472=+3.5")}\n10 L`),
    ),
    finished,
  ],
];

describe.each(works)("%s", (_, work, moment) => {
  const now = moment(work),
    { stock, apart } = work.at(now);
  const base = apart?.base ?? [],
    solid = apart && threaded(stock, apart, fine),
    mesh = solid && wholeMesh(solid);

  test("is closed and has the volume of its sections all round", () => {
    expect(mesh).not.toBeNull();
    if (!mesh) return;
    expect(openEdges(mesh)).toMatchObject({ open: 0 });
    const share = (fine.chords / (2 * Math.PI)) * Math.sin((2 * Math.PI) / fine.chords),
      slices = 16;
    const volumes = Array.from({ length: slices }, (__, i) => volumeTurned(sectionAt(work, base, now, i / slices)));
    const wanted = volumes.reduce((sum, v) => sum + v, 0) / slices,
      grooves = volumeTurned(base) - wanted;
    expect(grooves).toBeGreaterThan(100);
    expect(Math.abs(volumeOf(mesh) / share - wanted)).toBeLessThan(0.01 * grooves);
  });

  test("has its hand: its section a quarter of a turn over the operator is what the moves cut there, and in the mirror image the other way round", () => {
    for (const [hand, share] of [
      [1, 0.25],
      [-1, -0.25],
    ] as const) {
      const cut = apart && threaded(stock, apart, { ...fine, hand, quarterCut: true });
      expect(cut && openEdges(wholeMesh(cut)).open).toBe(0);
      const wanted = sectionAt(work, base, now, share),
        seen = cut ? lying(cut.section) : [];
      const grooves = areaOf(base) - areaOf(wanted);
      expect(areaOf(difference(seen, wanted)) + areaOf(difference(wanted, seen))).toBeLessThan(0.02 * grooves);
    }
  });
});
