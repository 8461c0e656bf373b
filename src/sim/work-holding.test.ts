import { describe, expect, test } from "vitest";
import type { Clamping } from "../kernel/area/clamping.ts";
import { boxAround } from "../kernel/area/box.ts";
import { at, type Ring } from "../kernel/geometry/point.ts";
import { brokenApart, holdOf, sameHold } from "./work-holding.ts";

const box = (left: number, low: number, right: number, high: number): Ring => [
  at(left, low),
  at(right, low),
  at(right, high),
  at(left, high),
];
const OUTSIDE: Clamping = { kind: "chuckOutside", diameter: 60, length: 20, face: -60, size: 200 };
const CENTRES: Clamping = {
  kind: "centres",
  diameter: 20,
  length: 0,
  face: -80,
  tailstock: { quill: 40, tip: -2, angle: 60 },
};

/** Inner radii of the held pieces and of the loose ones. */
function parted(blank: readonly Ring[], clamping: Clamping | null, stock: readonly Ring[]) {
  const hold = holdOf(blank, clamping) ?? expect.fail("a blank");
  const apart = brokenApart(stock, hold);
  return (
    apart && {
      held: apart.held.map((ring) => boxAround([ring]).low),
      loose: apart.loose.map(({ outline }) => boxAround([outline]).low),
    }
  );
}

describe("a core cut out of a bar through its whole length", () => {
  const bar = [box(-80, 0, 0, 30)],
    core = box(-80, 0, 0, 10),
    tube = box(-80, 13, 0, 30),
    stock = [tube, core];
  test("without a clamping both pieces reach the rear end and are held", () =>
    expect(parted(bar, null, stock)).toBeNull());
  test.each(["chuckOutside", "softJaws", "collet"] as const)("%s holds what is in its grip", (kind) =>
    expect(parted(bar, { ...OUTSIDE, kind }, stock)).toEqual({ held: [13], loose: [0] }),
  );
  test("jaws that do not reach the blank are ignored", () =>
    expect(parted(bar, { ...OUTSIDE, diameter: 80 }, stock)).toBeNull());
  test("with nothing left in the grip the rear end counts", () => {
    const rest = [box(-80, 0, -70, 8), box(-50, 0, 0, 10)];
    expect(parted(bar, { ...OUTSIDE, face: -70, length: 10 }, rest)?.held).toHaveLength(1);
  });
});

test("jaws in a bore hold the wall, not the ring cut off round it", () => {
  const tube = [box(-80, 20, 0, 40)],
    stock = [box(-80, 20, 0, 28), box(-80, 31, 0, 40)];
  expect(parted(tube, { ...OUTSIDE, kind: "chuckInside", diameter: 40 }, stock)).toEqual({ held: [20], loose: [31] });
});

describe("a bar cut through", () => {
  const bar = [box(-80, 0, 0, 30)],
    rear = box(-80, 0, -43, 30),
    front = box(-40, 0, 0, 30);
  const ends = (clamping: Clamping | null, stock: readonly Ring[] = [rear, front]) => {
    const apart = brokenApart(stock, holdOf(bar, clamping) ?? expect.fail("a blank"));
    return apart && { held: boxAround(apart.held), loose: boxAround(apart.loose.map(({ outline }) => outline)) };
  };
  test("loses its front in a chuck, even with a tailstock", () => {
    for (const clamping of [null, OUTSIDE, { ...OUTSIDE, tailstock: CENTRES.tailstock ?? expect.fail("a centre") }])
      expect(ends(clamping)).toMatchObject({ held: { right: -43 }, loose: { left: -40 } });
  });
  test("between centres both ends are held, and nothing between them", () => {
    expect(ends(CENTRES)).toBeNull();
    const between = box(-50, 0, -30, 15);
    expect(ends(CENTRES, [box(-80, 0, -52, 30), between, box(-28, 0, 0, 30)])).toEqual({
      held: { left: -80, right: 0, low: 0, high: 30 },
      loose: boxAround([between]),
    });
  });
  test("a centre that does not reach the work holds nothing", () =>
    expect(ends({ ...CENTRES, tailstock: { quill: 40, tip: 3, angle: 60 } })).toMatchObject({ loose: { left: -40 } }));
});

test("changes outside the grip keep the same hold", () => {
  expect(sameHold(OUTSIDE, { ...OUTSIDE, size: 160, limit: { z: -50 } })).toBe(true);
  expect(sameHold(OUTSIDE, { ...OUTSIDE, tailstock: { quill: 20, tip: -2, angle: 60 } })).toBe(true);
  for (const other of [null, CENTRES, { ...OUTSIDE, face: -59 }, { ...OUTSIDE, diameter: 59 }])
    expect(sameHold(OUTSIDE, other)).toBe(false);
  expect(sameHold(CENTRES, { ...CENTRES, tailstock: { quill: 40, tip: 3, angle: 60 } })).toBe(false);
});
