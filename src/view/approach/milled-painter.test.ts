import { expect, test } from "vitest";
import type { MillMotion } from "../../kernel/plane/mill-motion.ts";
import { milledStock } from "../../sim/plane/milled.ts";
import type { Patch, Pen } from "../material/pen.ts";
import { milledPainter, type MilledLook } from "./milled-painter.ts";

const spot = (x: number, y: number) => ({ x, y, z: -2.3 });
const feed = (x: number, to: number): MillMotion => ({
  kind: "feed",
  from: spot(x, 20),
  to: spot(to, 20),
  feed: 310,
  radius: 3.7,
  index: 0,
});
const MOTIONS = [feed(10, 30), feed(30, 50), feed(50, 70)];
const BLOCK = { left: 0, right: 90, low: 0, high: 40, bottom: -11, top: 0 };
const LOOK: MilledLook = {
  camera: { scale: 2, zero: { x: 7, y: 100 }, xUp: true },
  colours: { ground: "ground", edge: "edge", step: "step" },
  tones: ["deep"],
  ratio: 2,
  origin: { x: 7, y: 20, width: 180, height: 80 },
  ground: null,
};

/** A painter of a stock that is cut by the first so many motions, and the patches that it paints. */
function painting(cut: number) {
  const stock = milledStock({ motions: MOTIONS, bodies: [{ step: 0, body: { block: BLOCK, turned: null } }] });
  if (!stock) throw new Error("no stock");
  stock.advance(cut);
  const patches: Patch[] = [];
  let isFirst = true;
  const pen = new Proxy({} as Pen, {
    set: () => true,
    get: (_, key) => (x: number, y: number, width: number, height: number) => {
      // Repainting first clears the patch; through holes are cleared later.
      if (key === "clearRect" && isFirst) patches.push({ x, y, width, height });
      isFirst = key === "setTransform" || (isFirst && key !== "clearRect");
    },
  });
  return { painter: milledPainter(MOTIONS, stock), stock, pen, patches };
}

test("a later moment repaints only where the mill moved since, within the painted area", () => {
  const { painter, pen, patches } = painting(3);
  painter.all(pen, LOOK);
  expect(painter.follow(pen, LOOK, { step: 1, fraction: 0.5 })).toBe(true);
  // The mill from X10 to X40 with its radius, 3 pixels of edge, on half pixels.
  expect(patches).toEqual([LOOK.origin, { x: 16.5, y: 49.5, width: 81, height: 21 }]);
  expect(painter.at()).toEqual({ step: 1, fraction: 0.5 });
});

test("nothing is painted where no motion ran", () => {
  const { painter, pen, patches } = painting(3);
  painter.goTo({ step: 2, fraction: 0 });
  expect(painter.follow(pen, LOOK, { step: 2, fraction: 0 })).toBe(false);
  expect(patches).toEqual([]);
});

test("stock shown before its cut was complete is repainted in full once it is cut further", () => {
  const { painter, stock, pen, patches } = painting(0);
  painter.goTo({ step: 3, fraction: 0 });
  painter.all(pen, LOOK);
  stock.advance(3);
  expect(painter.follow(pen, LOOK, { step: 3, fraction: 0 })).toBe(true);
  expect(patches).toEqual([LOOK.origin, LOOK.origin]);
});
