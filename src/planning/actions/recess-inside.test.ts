import { expect, test } from "vitest";
import { requestOf } from "../../../tests/planning/plan-laws.ts";
import { at, type Pt } from "../../kernel/geometry/point.ts";
import { newRow } from "../../program/job/job.ts";
import { applyAction } from "../apply-action.ts";
import { newPart } from "../part/finished-part.ts";
import { recessInside } from "./recess-inside.ts";

const rows = (points: readonly Pt[]) => points.map(({ z, r }, i) => newRow(`${i}`, { z: `${z}`, x: `${2 * r}` }));

test("a groove is made to size while more than finishing takes is left elsewhere in the bore", () => {
  const groove = [at(-9, 14), at(-9, 15.3), at(-12, 15.3), at(-12, 14)];
  const bore = [at(0, 14), ...groove, at(-21, 14), at(-21, 11), at(-28, 11), at(-28, 14), at(-37, 14)];
  const part = { ...newPart("NECK"), outside: rows([at(0, 26), at(-37, 26)]), inside: rows(bore) };
  const request = requestOf({ ...part, blank: { outside: "52", bore: "20", length: "60", allowance: "0" } });
  if (!request) throw new Error("no part");
  // The groove has its skin, behind the neck nothing is cut.
  const cut = [at(0, 14), at(-9, 14), at(-9, 15), at(-12, 15), at(-12, 14), at(-21, 14), at(-21, 11), at(-60, 11)];
  const state = { stock: [[...cut.toReversed(), at(0, 26), at(-60, 26)]], done: [], threads: new Set<string>() };
  const [action] = recessInside.actions(state, request);
  if (!action) throw new Error("no recess");
  expect(action.place).toMatchObject({ front: -9, rear: -12 });
  expect(applyAction(action, state, request)).toMatchObject({ works: true, faults: [] });
});
