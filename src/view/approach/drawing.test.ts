import { describe, expect, test } from "vitest";
import { approach } from "../../kernel/plane/approach.ts";
import { compensate } from "../../kernel/plane/compensate.ts";
import type { PlanePoint, PlaneSegment } from "../../kernel/plane/plane.ts";
import { depthStrip, stripAt } from "./depth.ts";
import { dragged } from "./drag.ts";
import { helpSvg } from "../help/svg.ts";
import { approachDrawing } from "./drawing.ts";
import { suggestedForms } from "./forms.ts";
import { planeScene } from "./plane-scene.ts";

const corners = [
  [5, 5],
  [5, 95],
  [95, 95],
  [95, 5],
  [5, 5],
] as const;
const contour = corners.slice(1).map(([x, y], i): PlaneSegment => ({
  kind: "line",
  from: { x: corners[i]?.[0] ?? 0, y: corners[i]?.[1] ?? 0 },
  to: { x, y },
}));
const coordinates = (p: PlanePoint) => `X${Math.round(p.x * 1000) / 1000} Y${Math.round(p.y * 1000) / 1000}`;
const speech = {
  number: (n: number) => String(Math.round(n * 1000) / 1000),
  point: coordinates,
  contour: coordinates,
};
const forms = [false, true].flatMap((departing) =>
  suggestedForms({ contour, side: "left", toolRadius: 10, outside: departing ? null : { x: -30, y: -30 } }, departing),
);

describe.each(forms.map((f) => [`${f.departing ? "DEP" : "APPR"} ${f.shape}`, f] as const))(
  "%s",
  (name, { request, result }) => {
    const size = { width: 400, height: 280 };
    const centre = compensate(contour, "left", 10).pieces.map((p) => p.segment);
    const drawing = approachDrawing({
      result,
      contour,
      centre,
      toolRadius: 10,
      rapidBefore: true,
      active: null,
      size,
      small: false,
      speech,
    });

    test("is valid, and matches its golden drawing", async () => {
      expect(result.issues).toEqual([]);
      await expect(helpSvg({ ...drawing, labels: [] })).toMatchFileSnapshot(`goldens/${name.replace(" ", "-")}.svg`);
    });

    test("every circle of the tool is round: its halves meet across twice their radius", () => {
      const circles = drawing.marks.flatMap((m) => (m.kind === "line" && m.line === "edge" ? [m.d] : []));
      expect(circles.length).toBeGreaterThan(1);
      for (const d of circles) {
        const [left = 0, , radius = 0, , , , , right = 0] = d.match(/-?\d+(\.\d+)?/g)?.map(Number) ?? [];
        expect(right - left, d).toBeCloseTo(2 * radius, 6);
      }
    });

    test("names every point, without overlapping texts", () => {
      const texts = drawing.marks.flatMap((m) => (m.kind === "text" ? [m.text] : []));
      for (const point of Object.keys(result.points)) expect(texts.join()).toContain(point);
      expect(drawing.marks.map((m) => ("d" in m ? m.d : "")).join()).not.toMatch(/NaN|Infinity/);
    });

    test("dragging a handle along its line or circle gives the value that puts it there", () => {
      const handle = request.departing ? "PN" : "PH";
      if (request.shape === "LCT") return;
      const other = approach({
        ...request,
        ...(request.length !== undefined && { length: 23 }),
        ...(request.centreAngle !== undefined && { centreAngle: 40 }),
      });
      const to = other.points[handle];
      expect(to && dragged(result, handle, to, 0.1, { x: 0, y: 0 })).toEqual(
        request.shape === "CT" ? { word: "CCA", value: 40 } : { word: "LEN", value: 23 },
      );
    });
  },
);

test("the strip shows the height over the whole path", () => {
  const at = (x: number, z: number | null) => ({ x, y: 0, z });
  const strip = depthStrip([
    { kind: "rapid", from: at(0, 10), to: at(30, 10), radius: 5, index: 1 },
    {
      kind: "feed",
      from: at(30, 10),
      to: at(30, -10),
      feed: 100,
      radius: 5,
      index: 2,
    },
  ]);
  expect(strip).toMatchObject({ high: 10, low: -10, zero: 0.5, rapid: "M0 0L0.6 0", feed: "M0.6 0L1 1" });
  expect(strip && stripAt(strip, 1, 0.5)).toBeCloseTo(0.8);
});

test("programs of more motions than a call takes arguments have a strip and a picture", () => {
  const many = Array.from({ length: 150_000 }, (_, i) => ({
    kind: "feed" as const,
    from: { x: i / 1000, y: 0, z: -(i % 7) },
    to: { x: (i + 1) / 1000, y: 0, z: -((i + 1) % 7) },
    feed: 500,
    radius: 3.5,
    index: i,
  }));
  const { high, low } = depthStrip(many) ?? { high: 1, low: 1 };
  expect([high + 0, low]).toEqual([0, -6]);
  const { bounds } = planeScene(many, [], new Set());
  expect(bounds.left).toBeLessThan(-3.5);
  expect(bounds.right).toBeGreaterThan(153.5);
});

test("a strip of very many motions keeps the highest and the lowest place of every stretch", () => {
  const heights = Array.from({ length: 40_001 }, (_, i) => (i === 31_250 ? -9 : i > 10_000 && i < 20_000 ? -4 : 2));
  const motions = heights.slice(1).map((z, i) => ({
    kind: "feed" as const,
    from: { x: i, y: 0, z: heights[i] ?? 0 },
    to: { x: i + 1, y: 0, z },
    feed: 500,
    radius: 3.5,
    index: i,
  }));
  const { feed = "", begins = [] } = depthStrip(motions) ?? {};
  const lines = feed
    .split("M")
    .slice(1)
    .map((line) => line.split(/[ L]/).map(Number));
  const lowestNear = (place: number) =>
    Math.max(...lines.filter(([x = 0]) => Math.abs(x - place) < 3e-4).map(([, , , y = 0]) => y));
  expect(lowestNear(begins[31_250] ?? 0)).toBeCloseTo(1, 2);
  expect(lowestNear(begins[15_000] ?? 0)).toBeCloseTo(6 / 11, 2);
  expect(lowestNear(begins[25_000] ?? 0)).toBeCloseTo(0, 2);
  expect(feed.length).toBeLessThan(200_000);
});
