import { expect, test } from "vitest";
import { at } from "../../kernel/geometry/point.ts";
import type { Step } from "../../kernel/time/step.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { feed, length } from "../../kernel/units.ts";
import { stockFingerprints, milledFingerprints, type StockMaker } from "./stock-fingerprint.ts";

const tool: Tool = { T: 3, NAME: "A", TYPE: "ROUGH", TO: 1, RS: length(0.8) };
const step = (z: number, r: number, own = tool): Step => ({
  from: at(z + 1.3, r),
  move: { kind: "feed", to: at(z, r), feed: feed(0.2), feedUnit: "mm/rev", phase: "rough", run: "rough", step: 1 },
  tool: own,
  block: 12,
  operation: 0,
  seconds: 1,
});
const blank = [[at(-60.1, 0), at(1.2, 0), at(1.2, 25.3), at(-60.1, 25.3)]];
const steps = [step(-3.1, 24), step(-9.7, 22.5), step(-15.2, 21)];
const made = { blank, stated: [], steps };
const moment = (index: number, fraction = 0) => ({ step: index, fraction, block: 12 });
const print = (
  of: Parameters<typeof stockFingerprints>[0],
  ...asked: Parameters<ReturnType<typeof stockFingerprints>>
) => stockFingerprints(of)(...asked);

test("moves after a moment do not change its fingerprint; moves before it do", () => {
  const later = { ...made, steps: [...steps.slice(0, 2), step(-15.2, 20.999)] };
  expect(print(later, moment(2))).toBe(print(made, moment(2)));
  expect(print(later, moment(2, 0.3))).not.toBe(print(made, moment(2, 0.3)));
  expect(print({ ...made, steps: [step(-3.101, 24), ...steps.slice(1)] }, moment(2))).not.toBe(print(made, moment(2)));
  expect(print({ ...made, blank: [] }, moment(0))).not.toBe(print(made, moment(0)));
  expect(print(made, moment(2, 0.31))).not.toBe(print(made, moment(2, 0.3)));
});

test("another nose is another stock, another name or holder is not", () => {
  const other = (own: Partial<Tool>) => ({ ...made, steps: steps.map((s) => ({ ...s, tool: { ...tool, ...own } })) });
  expect(print(other({ RS: length(0.4) }), moment(1))).not.toBe(print(made, moment(1)));
  expect(
    print(
      other({ NAME: "B", holder: { width: length(25), length: length(80), offsetX: length(1), offsetZ: length(2) } }),
      moment(1),
    ),
  ).toBe(print(made, moment(1)));
});

test("the end is always the last moment; a moment that no longer exists has no fingerprint; the order of queries does not matter", () => {
  const longer = { ...made, steps: [...steps, step(-20, 19)] },
    end = { step: 3, fraction: 0 };
  expect(print(longer, end)).not.toBe(print(made, end));
  expect(print(made, end)).toBe(print(made, { step: 77, fraction: 0 }));
  expect(print(made, moment(4))).toBeNull();
  const asked = stockFingerprints(made),
    last = asked(moment(3)),
    first = asked(moment(1));
  expect([first, last]).toEqual([print(made, moment(1)), print(made, moment(3))]);
});

test("a blank that is stated on the way counts from its step on", () => {
  const stated = [{ step: 2, block: 40, what: "BLK FORM", rings: blank }];
  expect(print({ ...made, stated }, moment(1))).toBe(print(made, moment(1)));
  expect(print({ ...made, stated }, moment(2))).not.toBe(print(made, moment(2)));
});

test("milled stock changes with another path or another body, but not with later turning", () => {
  const spot = (x: number, y: number) => ({ x, y, z: -2.7 });
  const motion = {
    kind: "feed",
    from: spot(20.3, 0),
    to: spot(0, -20.3),
    feed: 200,
    radius: 3.1,
    index: 4,
    turned: 2,
  } as const;
  const arc = { ...motion, kind: "arc", centre: { x: 0, y: 0 }, turn: "ccw" } as const;
  const side = { ...motion, kind: "arc", side: { plane: "ZX", centre: { x: 4.2, z: 1.3 }, turn: "cw" } } as const;
  const none = { blank: [], stated: [], steps: [] },
    end = { step: 1, fraction: 0 };
  const prints = [motion, arc, { ...arc, turn: "cw" as const }, side, { ...motion, radius: 3.2 }].map((m) =>
    milledFingerprints(blank, [m], none)(end),
  );
  expect(new Set(prints).size).toBe(5);
  const on = (turned: StockMaker) => milledFingerprints(blank, [motion], turned)(end);
  expect(on({ ...made, steps: [step(-3.101, 24), ...steps.slice(1)] })).not.toBe(on(made));
  expect(on({ ...made, steps: [...steps.slice(0, 2), step(-15.2, 20.999)] })).toBe(on(made));
});
