import { describe, expect, test } from "vitest";
import { cuttingCycles } from "../../cycles/index.ts";
import type { Cycle } from "../../cycles/define.ts";
import type { Topic } from "../../cycles/params.ts";
import { guide } from "../../i18n/en/guide.ts";
import { ncLabels } from "../../i18n/nc-labels.ts";
import { at } from "../../kernel/geometry/point.ts";
import { diameter, toRadius } from "../../kernel/units.ts";
import { parse } from "../../nc/parse.ts";
import { readRows } from "../../program/job/contour-rows.ts";
import { exampleJob } from "../../program/job/job.ts";
import { printJob } from "../../program/job/print-job.ts";
import { run } from "../../program/run/run.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { simulate } from "../../sim/simulate.ts";
import type { Simulation } from "../../sim/simulation.ts";
import { demonstrate, type Demonstrated } from "./demonstrate.ts";
import { makesPath, type RanProgram } from "./shown-effect.ts";

/** Runs of a cycle by their values, shared by its prompts: most demonstrations include the example itself. */
const made = new Map<string, RanProgram>();

/** A run that simulates its stock lazily: for most values plan and time are enough. */
function ran(cycle: Cycle, values: Readonly<Record<string, number | "auto">>): RanProgram {
  const job = exampleJob(cycle);
  const typed = Object.fromEntries(
    Object.entries(values).map(([q, value]) => [q, value === "auto" ? "FAUTO" : String(value)]),
  );
  const drafts = { [cycle.number]: { ...job.drafts[cycle.number], ...typed } };
  const text = printJob({ ...job, drafts }, ncLabels("en"));
  const known = made.get(text);
  if (known) return known;
  const planned = run(parse(text), { tools: shippedTools, rapid: 9700 });
  let cut: Simulation | null = null;
  const outcome: RanProgram = {
    run: planned,
    get simulation() {
      return (cut ??= simulate(planned));
    },
  };
  made.set(text, outcome);
  return outcome;
}

function shown(cycle: Cycle, q: string): Promise<Demonstrated<RanProgram> | null> {
  const job = exampleJob(cycle);
  const values = Object.fromEntries(
    Object.entries(job.drafts[cycle.number] ?? {}).map(([name, text]) => [name, Number(text)]),
  );
  const { segments } = readRows(job.contour).contour;
  const given = {
    contour: cycle.contour === "free" ? segments : null,
    start: at(Number(job.start.z), toRadius(diameter(Number(job.start.x)))),
  };
  return demonstrate({ cycle, q, values, given }, (changed) => Promise.resolve(ran(cycle, changed)));
}

/**
 * Parameters without a visible effect in any situation: how many values look alike, and the reason given on their page.
 */
const ALIKE: Readonly<Record<string, Topic>> = {
  "815 Q486": "cuttingLines",
  "840 Q499": "reverse",
  "850 Q499": "reverse",
};
/** Choices that tool or start point of the example do not allow: their cards show the error. */
const REFUSED: readonly string[] = [
  "810 Q499",
  "815 Q499",
  "820 Q499",
  "830 Q461",
  "830 Q471",
  "831 Q471",
  "832 Q461",
  "832 Q471",
];

describe.each(cuttingCycles.map((cycle) => [cycle.number, cycle] as const))(
  "the pages of cycle %i",
  (number, cycle) => {
    const asked = Object.entries(cycle.params).filter(([, param]) => !param.reserved);
    test.each(asked)("%s is shown at values that can be told from each other", async (q, param) => {
      const found = await shown(cycle, q);
      const name = `${number} ${q}`;
      expect(found?.valueRuns.length).toBe(param.choices?.length ?? 3);
      expect(found?.valueRuns.filter(({ isUsual }) => isUsual).length).toBe(1);
      expect(found?.valueRuns.every(({ outcome }) => makesPath(outcome))).toBe(!REFUSED.includes(name));
      expect(found?.alikeCount).toBe(name in ALIKE ? 1 : 0);
      const reason = ALIKE[name];
      if (reason)
        expect([param.shown, guide.values.alike[reason as keyof typeof guide.values.alike]]).toEqual([
          reason,
          expect.any(String),
        ]);
      const values = found?.valueRuns.map(({ value }) => Number(value)) ?? [];
      const rising = values.toSorted((a, b) => a - b);
      if (!param.choices) expect([rising, rising.toReversed()]).toContainEqual(values);
    });
  },
);

test("a limit lies through the contour, from the side of the start point, and the other one out of its way", async () => {
  const found = await shown(cuttingCycles.find(({ number }) => number === 820) as Cycle, "Q480");
  // The printed contour runs between X20 and X75, its lowest point at Z-24.1; the tool is at X75 Z2.
  expect(found?.needed).toMatchObject({ Q479: 1, Q482: expect.closeTo(-26.1, 1) as number });
  const passes =
    found?.valueRuns.map(({ outcome }) => outcome.run.steps.filter(({ move }) => move.pass !== undefined).length) ?? [];
  expect(passes.every((count) => count > 0)).toBe(true);
  for (const { value } of found?.valueRuns ?? []) expect(value).toSatisfy((x: number) => x > 20 && x < 75);
});
