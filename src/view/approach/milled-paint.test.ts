import { expect, test } from "vitest";
import { at, type Ring } from "../../kernel/geometry/point.ts";
import type { MilledMoment } from "../../sim/plane/milled.ts";
import type { Pen } from "../material/pen.ts";
import { paintMilled, toneOfDepth } from "./milled-paint.ts";

const square = (left: number, low: number, size: number): Ring => [
  at(left, low),
  at(left + size, low),
  at(left + size, low + size),
  at(left, low + size),
];
const COLOURS = { ground: "ground", edge: "edge", step: "step" };
const CAMERA = { scale: 3.5, zero: { x: 21, y: 402 }, xUp: true };

/** A pen that records fills with the boxes of what they fill, and cleared areas. */
function noting() {
  const said: string[] = [];
  let spots: (readonly [number, number])[] = [],
    clips = 0;
  const around = () => {
    const [xs, ys] = [spots.map(([x]) => x), spots.map(([, y]) => y)];
    return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)].map((n) => Math.round(n)).join(" ");
  };
  const pen: Pen = new Proxy({} as Pen, {
    set: (of, key, value) => Reflect.set(of, key, value),
    get(of, key) {
      switch (key) {
        case "beginPath":
          return () => (spots = []);
        case "moveTo":
        case "lineTo":
          return (x: number, y: number) => spots.push([x, y]);
        case "clip":
          return () => (clips += 1);
        case "fill":
          return () => said.push(spots.length === 0 ? "nothing" : `${String(of.fillStyle)} ${around()}`);
        case "clearRect":
          return () => said.push(`clear within ${clips}`);
        case "stroke":
          return () => of.strokeStyle === "step" && spots.length > 99 && said.push(`hatch within ${clips}`);
        default:
          return () => undefined;
      }
    },
  });
  return { pen, said };
}

const moment: MilledMoment = {
  standing: [[square(20, 20, 30)], [square(10, 10, 60)], [square(0, 0, 100)]],
  swept: [[], [square(60, 60, 20)], [square(64, 64, 5)]],
  initialBands: [[square(0, 0, 100)], [], []],
};
const painted = (
  patch: { readonly x: number; readonly y: number; readonly width: number; readonly height: number },
  painting: MilledMoment = moment,
) => {
  const { pen, said } = noting();
  paintMilled(pen, { moment: painting, tones: ["shallow", "deep"] }, CAMERA, COLOURS, patch);
  return said;
};

test("the deepest area is painted first, then higher ones, then the sweep of the running motion; through holes are empty", () => {
  expect(painted({ x: 0, y: 0, width: 600, height: 500 })).toEqual([
    "clear within 1",
    "deep 21 52 371 402",
    "shallow 56 157 266 367",
    "ground 91 227 196 332",
    "deep 231 122 301 192",
    "clear within 4",
  ]);
});

test("an unmilled shoulder is hatched in the tone of its height, the top surface is not", () => {
  const shouldered: MilledMoment = {
    ...moment,
    swept: [[], [], []],
    initialBands: [[square(20, 20, 30)], [square(10, 10, 60)], []],
  };
  expect(painted({ x: 0, y: 0, width: 600, height: 500 }, shouldered)).toEqual([
    "clear within 1",
    "deep 21 52 371 402",
    "shallow 56 157 266 367",
    "hatch within 3",
    "ground 91 227 196 332",
  ]);
});

test("rings away from the patch are left out", () => {
  // Right of X70: nothing of the two upper areas.
  expect(painted({ x: 310, y: 100, width: 40, height: 40 }).slice(1)).toEqual([
    "deep 21 52 371 402",
    "nothing",
    "nothing",
    "nothing",
    "clear within 4",
  ]);
});

test("few depths use tones as far apart as possible", () => {
  expect([1, 2, 3, 5].map((depths) => Array.from({ length: depths }, (_, i) => toneOfDepth(i, depths)))).toEqual([
    [2],
    [0, 4],
    [0, 2, 4],
    [0, 1, 2, 3, 4],
  ]);
});
