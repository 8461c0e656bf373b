/**
 * Laws of the values that findings propose, for drawn set-ups of every cycle and for the examples with one changed
 * value.
 */
import fc from "fast-check";
import { expect, test } from "vitest";
import type { Cycle, Given } from "../../src/cycles/define.ts";
import { firstValues } from "../../src/cycles/first-values.ts";
import { catalogue } from "../../src/cycles/index.ts";
import type { Params, Values } from "../../src/cycles/params.ts";
import { contourFrom } from "../../src/kernel/contour/contour.ts";
import type { Issue } from "../../src/kernel/plan/issue.ts";
import { fixesFinding, offerOf } from "../../src/kernel/plan/offer.ts";
import type { PlanContext } from "../../src/kernel/plan/plan.ts";
import { at } from "../../src/kernel/geometry/point.ts";
import { axial, diameter, feed, toRadius } from "../../src/kernel/units.ts";
import { cylinder } from "../../src/program/state/blank-form.ts";
import { checkNumber } from "../../src/program/values/field.ts";
import { shippedTools } from "../../src/program/tools/shipped-tools.ts";
import { dimensionSlip } from "../../src/program/values/dimension-slips.ts";
import { judgeOf, testedOffers } from "../../src/program/values/tested-offers.ts";
import { printed } from "../validation-rules.ts";
import { situations } from "./situation.ts";

type Numbers = Readonly<Record<string, number>>;

/** The issues of a cycle's values as a call reports them, with tried proposals. */
function saidOf(cycle: Cycle, values: Numbers, setting: PlanContext, given: Given) {
  const judge = judgeOf(cycle, setting, given);
  if (!judge) return { judge, raw: [], said: [] };
  const ranges = Object.entries(cycle.params).flatMap(
    ([q, param]) => checkNumber({ ...param, id: q }, values[q] ?? 0) ?? [],
  );
  const raw: readonly Issue[] = ranges.length > 0 ? ranges : judge(values as unknown as Values<Params>).issues;
  const slip =
    ranges.length > 0
      ? null
      : dimensionSlip({
          cycle,
          values: values as unknown as Values<Params>,
          setting,
          judge,
          outlined: raw,
          planned: [],
        });
  const usable = Object.fromEntries(Object.entries(values).filter(([q]) => !ranges.some((each) => each.at === q)));
  return { judge, raw, said: slip ?? testedOffers(cycle.params, usable, raw, judge, given.start) };
}

/** Number of proposals checked. */
const looked = { parameters: 0, signs: 0 };

/** The faults of the proposals for a set-up, in words. */
function faultsOf(cycle: Cycle, values: Numbers, setting: PlanContext, given: Given): string[] {
  const { judge, raw, said } = saidOf(cycle, values, setting, given);
  return said.flatMap((found): string[] => {
    const [offer, q] = [offerOf(found), found.at];
    const param = q === undefined ? undefined : cycle.params[q];
    if (offer === null || q === undefined || !param || !judge) return [];
    const name = `${found.code} ${q} ${String(values[q])} -> ${offer}`;
    looked.parameters += 1;
    const isSign = offer === -(values[q] ?? NaN);
    if (isSign) looked.signs += 1;
    if (param.drawn && !isSign) return [`${name}: a dimension of the drawing`];
    const judged = judge({ ...values, [q]: offer } as unknown as Values<Params>);
    const out = fixesFinding(found, raw, judged.issues) ? [] : [`${name}: does not mend it`];
    const many = param.shown === "infeed" && (judged.passes ?? 0) > 100 ? [`${name}: ${judged.passes} passes`] : [];
    return [
      ...out,
      ...many,
      ...(String(offer).replace(/^-?\d*\.?/, "").length > 3 && param.kind !== "angle"
        ? [`${name}: nobody types it`]
        : []),
    ];
  });
}

const settingOf = (
  tool: PlanContext["tool"],
  start: PlanContext["start"],
  blank: NonNullable<PlanContext["stock"]>,
): PlanContext => ({
  tool,
  start,
  feedUnit: "mm/rev",
  autoFeed: feed(0.25),
  stock: blank,
  blank,
});

test.each(situations(0))(
  "$cycle.number: an offer changes no dimension, and mends what it is offered for",
  ({ cycle, arbitrary }) => {
    fc.assert(
      fc.property(arbitrary, ({ values, given, tool, start, blank }) => {
        expect(faultsOf(cycle, values, settingOf(tool, start, blank), given)).toEqual([]);
      }),
      { numRuns: 3 },
    );
  },
);

const contour = contourFrom(printed).segments;
/** Typing errors: a wrong sign, and in turn too many digits or 0. */
const slipsOf = (value: number, turn: number): readonly number[] => [-value, turn % 2 === 0 ? value * 30 : 0];

test("so do examples with a disturbed value", () => {
  const faults = catalogue
    .filter(({ group }) => group !== "special")
    .flatMap((cycle) => {
      const { setup } = cycle,
        tool = shippedTools.find(({ T }) => T === setup.tool);
      if (!tool) throw new Error(`no tool ${setup.tool}`);
      const measure = (text: string) => Number(text === "" ? 0 : text);
      const { outside, bore, length, allowance } = setup.blank;
      const half = (text: string) => toRadius(diameter(measure(text)));
      const blank =
        cylinder({ outside: half(outside), inside: half(bore), length: measure(length), front: measure(allowance) }) ??
        [];
      const start = at(axial(measure(setup.start.z)), half(setup.start.x));
      const given: Given = { contour: cycle.contour === "free" ? contour : null, start };
      const values = firstValues(cycle);
      const setting = settingOf(tool, start, blank);
      return Object.keys(cycle.params).flatMap((q, i) =>
        slipsOf(values[q] ?? 0, cycle.number + i)
          .flatMap((value) => faultsOf(cycle, { ...values, [q]: value }, setting, given))
          .map((fault) => `${cycle.number}: ${fault}`),
      );
    });
  expect(faults).toEqual([]);
  expect(looked.parameters).toBeGreaterThan(100);
  expect(looked.signs).toBeGreaterThan(20);
});
