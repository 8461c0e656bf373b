import { expect, test } from "vitest";
import type { Move } from "../kernel/plan/move.ts";
import { at, type Pt } from "../kernel/geometry/point.ts";
import type { Step } from "../kernel/time/step.ts";
import { shippedTools } from "../program/tools/shipped-tools.ts";
import { moveAt, positionNear } from "./pick.ts";

const [tool] = shippedTools;
const step = (from: Pt, move: Pick<Move, "kind"> & { readonly to: Pt }): Step =>
  ({
    from,
    move: { phase: "rough", run: "rough", step: 2, ...move },
    tool,
    block: 7,
    operation: 0,
    seconds: 1,
  }) as unknown as Step;

const steps: readonly Step[] = [
  step(at(2.3, 31.7), { kind: "rapid", to: at(2.3, 28.4) }),
  step(at(2.3, 28.4), { kind: "feed", to: at(-41.9, 28.4) }),
  step(at(-41.9, 28.4), { kind: "rapid", to: at(2.3, 28.4) }),
  step(at(2.3, 28.4), { kind: "feed", to: at(-41.9, 25.1) }),
];

test("where a rapid lies on a cut, the cut is picked", () => {
  expect(moveAt(steps, at(-17.7, 28.45), 0.3)).toBe(1);
  expect(moveAt(steps, at(2.35, 30.2), 0.3)).toBe(0);
});
test("nothing is picked beside the path, or where its moves are hidden", () => {
  expect(moveAt(steps, at(-17.7, 29.9), 0.3)).toBeNull();
  expect(moveAt(steps, at(-17.7, 28.45), 0.3, (i) => i !== 1)).toBe(2);
});
test("the tool goes to the place on the move, and stays on it at its end", () => {
  expect(positionNear(steps, 1, at(-17.7, 29))).toEqual({ step: 1, fraction: expect.closeTo(20 / 44.2, 9) });
  expect(positionNear(steps, 1, at(-60, 28)).fraction).toBeLessThan(1);
  expect(positionNear(steps, 1, at(9.1, 28))).toEqual({ step: 1, fraction: 0 });
  expect(positionNear(steps, 11, at(0, 0))).toEqual({ step: 11, fraction: 0 });
});
