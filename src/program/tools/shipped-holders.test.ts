import { describe, expect, test } from "vitest";
import { areaOf } from "../../kernel/area/area.ts";
import { intersection } from "../../kernel/area/clip.ts";
import { holderOutlines, mirroredTool } from "../../kernel/cutter/holder.ts";
import { insertOutline, insertShape, isBar } from "../../kernel/cutter/insert.ts";
import type { Pt, Ring } from "../../kernel/geometry/point.ts";
import { axial, radius } from "../../kernel/units.ts";
import { shippedTools } from "./shipped-tools.ts";

/** Smallest overhang of the insert over its pocket, mm. */
const LEAST = 0.3;
const tools = shippedTools.map((tool) => [tool.NAME, tool] as const);

/** Distance of a corner behind the nearest cutting edge, with the edges extended indefinitely. */
const behindEdges = (tool: (typeof shippedTools)[number], p: Pt) => {
  const edges = insertShape(tool).filter(
    (e) => e.kind === "line" && (e.feature === "mainEdge" || e.feature === "secondaryEdge"),
  );
  return Math.min(
    ...edges.map((e) => {
      if (e.kind !== "line") return Infinity;
      const [u, v] = [e.to.u - e.from.u, e.to.v - e.from.v];
      return (u * (p.r - e.from.v) - v * (p.z - e.from.u)) / Math.hypot(u, v);
    }),
  );
};

test("every shipped tool has a holder", () => expect(shippedTools.filter((tool) => !tool.holder)).toEqual([]));

describe("a shipped holder", () => {
  test.each(tools.filter(([, tool]) => tool.TYPE === "ROUGH" || tool.TYPE === "FINISH"))(
    "%s has a head behind both cutting edges, however long they were",
    (_, tool) => {
      for (const p of holderOutlines(tool)[0] ?? []) expect(behindEdges(tool, p)).toBeGreaterThan(LEAST);
    },
  );

  test.each(tools.filter(([, tool]) => isBar(tool)))(
    "%s has a blade inside the cut, down to where the shank begins",
    (_, tool) => {
      const [blade, shank] = holderOutlines(tool) as [Ring, Ring];
      for (const p of blade) expect(behindEdges(tool, p)).toBeGreaterThanOrEqual(0.199);
      expect(areaOf(intersection([shank], [insertOutline(tool, 1e-3)]))).toBeLessThan(1e-6);
    },
  );

  test.each(tools)("%s stays inside its insert where the edge is, and its parts hang together", (_, tool) => {
    const outlines = holderOutlines(tool);
    const insert = insertOutline(tool, 1e-3);
    // The tooth of a thread insert is free; its holder begins behind it.
    const held = tool.TYPE === "THREAD" ? insert.map(({ z, r }) => ({ z, r: r + Math.sign(r) }) as Pt) : insert;
    expect(areaOf(intersection([outlines[0] as Ring], [held]))).toBeGreaterThan(1);
    const near: Ring = insert.filter((p) => Math.hypot(p.z, p.r) < 1.5);
    for (const p of near)
      for (const part of outlines) expect(part.some((q) => Math.hypot(q.z - p.z, q.r - p.r) < LEAST)).toBe(false);
    outlines.slice(1).forEach((part, i) => {
      const touching =
        part.some((p) => (outlines[i] as Ring).some((q) => Math.abs(p.z - q.z) < 1e-9 && Math.abs(p.r - q.r) < 1e-9)) ||
        areaOf(intersection([part], [outlines[i] as Ring])) > 0.01;
      expect(touching).toBe(true);
    });
  });

  test("the left-hand holder is the mirror image of the right-hand one", () => {
    const [right, left] = [2, 7].map((n) => shippedTools.find((tool) => tool.T === n)) as [
      (typeof shippedTools)[number],
      (typeof shippedTools)[number],
    ];
    const corners = (tool: typeof right) =>
      holderOutlines(tool).map((ring) => ring.map((p) => `${p.z + 0} ${p.r}`).sort());
    expect(corners(mirroredTool(right, "z"))).toEqual(corners(left));
  });
});

const sides = (ring: Ring) => {
  const [z, r] = [ring.map((p) => p.z), ring.map((p) => p.r)];
  return [Math.min(...z), Math.max(...z), Math.min(...r), Math.max(...r)].map((n) => Math.round(n * 1e3) / 1e3 + 0);
};
const at = (x: number) => Math.round(x * 1e6) / 1e6 + 0;
const places = (rings: readonly Ring[]) => rings.map((ring) => ring.map((p) => `${at(p.z)} ${at(p.r)}`).sort());
const flipped = (ring: Ring, axis: "z" | "r"): Ring =>
  ring.map((p) => (axis === "z" ? { ...p, z: axial(-p.z) } : { ...p, r: radius(-p.r) }));

describe.each(["z", "r"] as const)("mirrored along %s", (axis) => {
  test.each(tools)("%s keeps its holder where its insert is", (_, tool) => {
    const twin = mirroredTool(tool, axis);
    expect(places(holderOutlines(twin))).toEqual(places(holderOutlines(tool).map((ring) => flipped(ring, axis))));
    expect(sides(insertOutline(twin, 1e-4))).toEqual(sides(flipped(insertOutline(tool, 1e-4), axis)));
  });
});
