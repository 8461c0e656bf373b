import fc from "fast-check";
import { expect, test } from "vitest";
import { areaOf } from "../kernel/area/area.ts";
import type { Move } from "../kernel/plan/move.ts";
import type { Pt, Ring } from "../kernel/geometry/point.ts";
import type { Step } from "../kernel/time/step.ts";
import type { Tool } from "../kernel/plan/tool.ts";
import { axial, feed, length, radius } from "../kernel/units.ts";
import { cutting } from "./cutting.ts";
import { holderContact, mayTouch } from "./holder.ts";
import { outlinesOf } from "./outlines.ts";
import { sweptBy } from "./sweep.ts";

const at = (z: number, r: number): Pt => ({ z: axial(z), r: radius(r) });
const box = (z0: number, r0: number, z1: number, r1: number): Ring => [at(z0, r0), at(z1, r0), at(z1, r1), at(z0, r1)];
const mm = (least: number, most: number) => fc.integer({ min: least * 100, max: most * 100 }).map((n) => n / 100);
const purpose = { feed: feed(0.2), feedUnit: "mm/rev", phase: "rough", run: "rough", step: 1 } as const;
const bar: Tool = {
  T: 9,
  NAME: "BAR-3",
  TYPE: "RECTURN",
  TO: 2,
  RS: length(0.2),
  CUTWIDTH: length(3),
  CUTLENGTH: length(30),
};
const tools = [
  { width: length(20), length: length(60), offsetZ: length(-1), offsetX: length(6) },
  {
    width: length(2),
    length: length(60),
    offsetZ: length(0.5),
    offsetX: length(2),
  },
  { width: length(8), length: length(60), offsetZ: length(-4), offsetX: length(9) },
].map((holder): Tool => ({ ...bar, holder }));
const outlines = outlinesOf();

test("the quick check never misses a holder contact, and always skips a holder in the air", () => {
  let [touched, passed] = [0, 0];
  const ways = fc.array(fc.tuple(mm(-40, 5), mm(4, 36), fc.boolean(), mm(0.5, 6)), { minLength: 1, maxLength: 12 });
  fc.assert(
    fc.property(fc.constantFrom(...tools), ways, (tool, way) => {
      const cut = cutting([box(-50, 0, 0, 30), box(3, 10, 8, 20)]);
      let from = at(-20, 35);
      for (const [z, r, round, size] of way) {
        const arc = round && size < 5;
        const move: Move = arc
          ? {
              kind: "arc",
              to: at(from.z + size, from.r - size),
              centre: at(from.z + size, from.r),
              turn: "ccw",
              ...purpose,
            }
          : { kind: "feed", to: at(z, r), ...purpose };
        const step: Step = { from, move, tool, block: 1, operation: null, seconds: 1 };
        const hit = areaOf(holderContact(step, outlines(tool), cut.present()));
        const may = mayTouch(step, outlines(tool), cut.present());
        if (hit > 0) expect(may).toBe(true);
        touched += hit > 0 ? 1 : 0;
        passed += may ? 0 : 1;
        cut.add(sweptBy(outlines(tool).insert, step));
        from = move.to;
      }
    }),
    { numRuns: 60 },
  );
  expect(touched).toBeGreaterThan(10);
  expect(passed).toBeGreaterThan(10);
});
