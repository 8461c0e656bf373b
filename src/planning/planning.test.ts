import { expect, test } from "vitest";
import { at, part } from "../kernel/geometry/point.ts";
import { ncLabels } from "../i18n/nc-labels.ts";
import { shippedTools } from "../program/tools/shipped-tools.ts";
import { face } from "./actions/face.ts";
import { applyAction } from "./apply-action.ts";
import { borderOf, openRegions } from "./open-regions.ts";
import type { PlanRequest, PlannedPart } from "./types.ts";

const corners = [at(0, 0), at(0, 18), at(-2, 20), at(-40, 20), at(-40, 28), at(-60, 28)];
const pin: PlannedPart = {
  name: "PIN",
  outside: {
    segments: corners.slice(1).map((to, i) => part.line(corners[i] ?? to, to)),
    marks: corners.slice(1).map((_, i) => ({ row: `e${i}` })),
  },
  inside: { segments: [], marks: [] },
  rings: [[...corners, at(-60, 0)].reverse()],
};
const request: PlanRequest = {
  part: pin,
  blank: [[at(-80, 0), at(2, 0), at(2, 30), at(-80, 30)]],
  clamping: null,
  shop: { tools: shippedTools, rapid: 10_000 },
  material: "C45",
  rules: {
    toolChange: 5,
    usualTool: 0,
    finishBeforeRough: 60,
    insideBeforeOutside: 5,
    thinBeforeLong: 20,
    tolerancedLast: 20,
    allowance: { diameter: 0.5, z: 0.1 },
  },
  partsOff: false,
  withoutCycles: [],
  withoutTools: [],
  labels: ncLabels("en"),
};

test("a region borders the elements of its side", () => {
  const [region, ...rest] = openRegions(request.blank, pin);
  expect(rest).toEqual([]);
  expect(region && borderOf(pin.outside, region)).toEqual([0, 4]);
});

test("facing takes the stock in front of Z0 and nothing of the part", () => {
  const state = { stock: request.blank, done: [], threads: new Set<string>() };
  const tried = face.actions(state, request).map((a) => applyAction(a, state, request));
  const works = tried.filter((t) => t.works);
  expect(works.length).toBeGreaterThan(0);
  for (const t of works) expect(t.cut).toBeCloseTo(60, 0);
});
