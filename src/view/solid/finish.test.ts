import { expect, test } from "vitest";
import { at, type Ring } from "../../kernel/geometry/point.ts";
import type { Move } from "../../kernel/plan/move.ts";
import { feed } from "../../kernel/units.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { simulate } from "../../sim/simulate.ts";
import { playerOf } from "../../sim/stock.ts";
import { surfacesOf } from "../material/surfaces.ts";
import { stockLooksOf, TEXTURE_CODES } from "./finish.ts";
import { profileOf } from "./profile.ts";
import { revolved } from "./revolve.ts";
import type { TonedSide } from "./tones.ts";

const tool = shippedTools[0] ?? expect.fail("there are tools");
const rough = { phase: "rough", run: "rough", step: 2, pass: 1 } as const,
  finish = { phase: "finish", run: "finish", step: 2 } as const;
const BLANK: Ring = [at(-63.7, 0), at(0.8, 0), at(0.8, 25.3), at(-63.7, 25.3)];
const PITCH = 0.31;
const moves: readonly Move[] = [
  { kind: "rapid", to: at(2.3, 22.37), ...rough },
  { kind: "feed", to: at(-29.81, 22.37), feed: feed(PITCH), feedUnit: "mm/rev", ...rough },
  { kind: "rapid", to: at(2.3, 26), ...rough },
  { kind: "rapid", to: at(2.3, 21.13), ...finish },
  { kind: "feed", to: at(-11.3, 21.13), feed: feed(0.12), feedUnit: "mm/rev", ...finish },
  { kind: "rapid", to: at(-11.3, 26), ...finish },
  { kind: "rapid", to: at(-15.3, 26), ...finish },
  // Passes over the surface of the first cut without removing anything.
  { kind: "rapid", to: at(-15.3, 22.37), ...finish },
  { kind: "feed", to: at(-24.9, 22.37), feed: feed(0.12), feedUnit: "mm/rev", ...finish },
];
const steps = moves.map((move, i) => ({
  from: moves[i - 1]?.to ?? at(2.3, 26),
  move,
  tool,
  block: 3,
  operation: 0,
  seconds: 1,
}));
const player = playerOf(simulate({ blank: [BLANK], steps, operations: [], unproved: [] })),
  surfaces = surfacesOf(steps);

/** The level sides of the turned stock, by radius: their range, their look, and the turns at both ends. */
function level(step: number, tones: readonly TonedSide[] = []) {
  const now = { step, fraction: 0 },
    rings = player.at(now),
    told = stockLooksOf(rings, surfaces, now, tones);
  const { positions, looks, index } = revolved(rings, { chords: 32, quarterCut: true, finish: told }).surface;
  const out = new Map<string, readonly [number, number, number, number]>();
  for (let i = 0; i < index.length; i += 3) {
    const ends = [0, 1, 2]
      .map((k) => index[i + k] ?? 0)
      .map((c) => ({
        z: positions[3 * c + 2] ?? 0,
        r: Math.hypot(positions[3 * c] ?? 0, positions[3 * c + 1] ?? 0),
        texture: looks?.[2 * c] ?? -1,
        turn: looks?.[2 * c + 1] ?? -1,
      }))
      .sort((a, b) => a.z - b.z);
    const [p, , q] = ends;
    if (!p || !q || q.z - p.z < 1 || Math.abs(p.r - q.r) > 0.001) continue;
    expect(ends.every(({ texture }) => texture === p.texture)).toBe(true);
    const tone = Math.floor(p.texture / TEXTURE_CODES.length) - 1,
      texture = TEXTURE_CODES[p.texture % TEXTURE_CODES.length] ?? "?";
    out.set(`${texture}${tone < 0 ? "" : ` (${tone})`} ${p.r.toFixed(2)} ${p.z.toFixed(1)}`, [
      p.z,
      q.z,
      p.turn,
      q.turn,
    ]);
  }
  return { of: [...out.keys()].sort(), out, textures: told.textures };
}

test("every corner knows its texture, and sides are split where the texture changes", () => {
  expect(level(0)).toMatchObject({ of: ["raw 25.30 -63.7"], textures: ["raw"] });
  expect(level(3)).toMatchObject({ of: ["raw 25.30 -63.7", "rough 22.37 -29.0"], textures: ["raw", "rough"] });
  // The nose, 0.8 mm, touches a level surface so much before the tip.
  expect(level(steps.length).of).toEqual([
    "finished 21.13 -10.5",
    "finished 22.37 -24.1",
    "raw 25.30 -63.7",
    "rough 22.37 -14.5",
    "rough 22.37 -29.0",
  ]);
});

test("feed marks are one turn of the work apart, on rough surfaces only", () => {
  const { out } = level(3),
    [from, to, first, last] = out.get("rough 22.37 -29.0") ?? expect.fail("it was roughed");
  expect(Math.abs(last - first)).toBeCloseTo((to - from) / PITCH, 3);
  // The first turn is counted from where the move begins.
  expect(Math.abs(last)).toBeCloseTo((2.3 - to) / PITCH, 3);
  const finished = level(steps.length).out.get("finished 21.13 -10.5") ?? expect.fail("it was finished");
  expect([finished[2], finished[3]]).toEqual([0, 0]);
});

/**
 * Tones of the finished surface: the finest cut in two tones, the level that was cut again in one from its middle on.
 */
const TONES: readonly TonedSide[] = [
  { z0: -0.42, r0: 21.13, z1: -4.7, r1: 21.13, tone: 0 },
  {
    z0: -4.7,
    r0: 21.13,
    z1: -10.517,
    r1: 21.13,
    tone: 6,
  },
  { z0: -19.35, r0: 22.37, z1: -29.03, r1: 22.37, tone: 3 },
];

test("a surface has its tone where it is final, and is split where the tone changes", () => {
  // Feed marks remain under a tone.
  expect(level(steps.length, TONES).of).toEqual([
    "finished (0) 21.13 -4.7",
    "finished (3) 22.37 -24.1",
    "finished (6) 21.13 -10.5",
    "finished 21.13 -0.4",
    "finished 22.37 -19.4",
    "raw 25.30 -63.7",
    "rough (3) 22.37 -29.0",
    "rough 22.37 -14.5",
  ]);
  const { out } = level(steps.length, TONES),
    [, , first, last] = out.get("rough (3) 22.37 -29.0") ?? expect.fail("it has a tone");
  expect(Math.abs(last - first)).toBeGreaterThan(10);
  // Before the last cuts the finest surface does not exist yet.
  expect(level(3, TONES).of).toEqual(["raw 25.30 -63.7", "rough (3) 22.37 -29.0", "rough 22.37 -19.4"]);
});

test("an edge that runs backwards or lies beside a surface gives it no tone", () => {
  const aside = TONES.flatMap(({ z0, r0, z1, r1, tone }) => [
    { z0: z1, r0: r1, z1: z0, r1: r0, tone },
    { z0, r0: r0 + 0.05, z1, r1: r1 + 0.05, tone },
  ]);
  expect(level(steps.length, aside).of).toEqual(level(steps.length).of);
});

test("a side too short to see takes a tone between two tones; at the end of a tone it has none", () => {
  const outline: Ring = [
    at(0, 5),
    at(-4.1, 5),
    at(-4.2, 5.02),
    at(-9.3, 5.6),
    at(-9.4, 5.7),
    at(-12, 5.7),
    at(-12, 9),
    at(0, 9),
  ];
  const looks = profileOf(outline, {
    textures: ["finished"],
    changes: () => [],
    of: (p, q) => ({ texture: "finished", turnAt: null, tone: p.r <= 5.6 && Math.abs(q.z - p.z) > 1 ? 4 : null }),
  })?.looks;
  expect(looks?.slice(0, 6).map((look) => look?.tone)).toEqual([4, 4, 4, null, null, null]);
});
