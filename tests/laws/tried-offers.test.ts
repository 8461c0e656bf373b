/**
 * Laws of the offers of the page, for every cycle and every number prompt with one disturbed value in the printed
 * example: what "Use …" sets removes its finding, adds no error of prompts, plan or check, and leads to no further
 * offer.
 */
import fc from "fast-check";
import { expect, test } from "vitest";
import type { Outcome } from "../../src/app/calculation/outcome.ts";
import { engine } from "../../src/app/calculation/engine.ts";
import { printedText } from "../../src/app/document/printed.ts";
import { readJob } from "../../src/app/document/reading.ts";
import type { FindingEntry } from "../../src/app/findings/entry.ts";
import { findingsOf } from "../../src/app/findings/findings.ts";
import { nearestOf } from "../../src/app/findings/host.ts";
import type { Cycle } from "../../src/cycles/define.ts";
import { firstValues } from "../../src/cycles/first-values.ts";
import { cuttingCycles } from "../../src/cycles/index.ts";
import type { Param } from "../../src/cycles/params.ts";
import { exampleJob, UNSET, type Job } from "../../src/program/job/job.ts";
import { shippedTools } from "../../src/program/tools/shipped-tools.ts";

const outcomeOf = (text: string): Outcome =>
  engine.update({
    version: 1,
    text,
    table: { tools: shippedTools, mills: [], refused: new Map() },
    rapid: 10_000,
    control: "TNC 640",
  });

/** The findings that the page shows for a job. */
function shown(job: Job): readonly FindingEntry[] {
  const read = readJob(job, shippedTools);
  return findingsOf(read, read?.reading.values ? outcomeOf(printedText(job)) : null);
}

const typed = (job: Job, q: string, value: number): Job => ({
  ...job,
  drafts: { [job.cycle]: { ...job.drafts[job.cycle], [q]: String(value) } },
});

const rounded = (n: number) => Number(n.toFixed(3));
/** Typing errors: the other sign, none, one digit more or less, and beyond the range. */
function slipsOf({ range: [min, max] }: Param, value: number): readonly number[] {
  const own = value === 0 ? [1, -1, 3, -3, 11, -11] : [-value, 0, rounded(value * 10), rounded(value / 10)];
  return [...new Set([...own, min - 1, max + 1])].filter((each) => each !== value);
}

const isNew = (entry: FindingEntry, before: readonly FindingEntry[]) =>
  !before.some((each) => each.issue.code === entry.issue.code && each.at === entry.at);

const counts = { offers: 0 };

/** The faults of the offers for one disturbed value, in words. */
function faultsOf(job: Job, q: string, value: number): readonly string[] {
  const before = shown(typed(job, q, value));
  return before.flatMap((entry): readonly string[] => {
    const offer = nearestOf(entry);
    if (offer === null || entry.at === null || !(entry.at in (job.drafts[job.cycle] ?? {}))) return [];
    counts.offers += 1;
    const name = `${job.cycle} ${q}=${value}: ${entry.issue.code} ${entry.issue.severity} ${entry.at} -> ${offer}`;
    const after = shown(typed(typed(job, q, value), entry.at, offer));
    const stays = after.some((each) => each.issue.code === entry.issue.code && each.at === entry.at);
    const added = after.filter((each) => each.issue.severity === "error" && isNew(each, before));
    const again = after.filter((each) => each.at === entry.at && nearestOf(each) !== null && isNew(each, before));
    return [
      ...(stays ? [`${name}: stays`] : []),
      ...added.map(({ issue, at }) => `${name}: adds ${issue.code} ${at ?? ""}`),
      ...again.map((each) => `${name}: offers ${nearestOf(each)} for ${each.issue.code}`),
    ];
  });
}

const setUps = {
  printed: (cycle: Cycle): Job => exampleJob(cycle),
  proposed: (cycle: Cycle): Job => ({ ...exampleJob(cycle), ...UNSET }),
};

/** A disturbed value of an example. */
interface Disturbed {
  readonly cycle: Cycle;
  readonly kind: keyof typeof setUps;
  readonly q: string;
  readonly value: number;
}

const all: readonly Disturbed[] = cuttingCycles.flatMap((cycle) =>
  Object.entries<Param>(cycle.params)
    .filter(([, param]) => !param.choices)
    .flatMap(([q, param]) => slipsOf(param, firstValues(cycle)[q] ?? 0).map((value) => ({ cycle, q, value })))
    .flatMap((each) => (["printed", "proposed"] as const).map((kind) => ({ ...each, kind }))),
);

test("an offer mends what it is offered for", () => {
  expect(all.length).toBeGreaterThan(4000);
  fc.assert(
    fc.property(fc.constantFrom(...all), ({ cycle, kind, q, value }) => {
      expect(faultsOf(setUps[kind](cycle), q, value)).toEqual([]);
    }),
    { numRuns: 200 },
  );
  expect(counts.offers).toBeGreaterThan(40);
});

// Each of them once led to an error, or to another offer.
test.each<[number, string, number, string]>([
  [831, "Q492", 11, "a sign whose other one has no run-in"],
  [831, "Q473", -3, "a depth above the tooth"],
  [831, "Q467", 101, "a range wider than the tool"],
  [831, "Q460", 0.5, "a run-in too short for the speed"],
  [851, "Q463", 0.2, "an offset that is reduced"],
  [813, "Q495", -1, "an angle at which the holder collides"],
  [830, "Q466", 100.9, "an overrun behind the blank"],
])("so do %i with %s=%d: %s", (number, q, value) => {
  const cycle = cuttingCycles.find((each) => each.number === number);
  if (!cycle) throw new Error(`no cycle ${number}`);
  for (const setUp of Object.values(setUps)) expect(faultsOf(setUp(cycle), q, value)).toEqual([]);
});

test("an invalid value gets what its run offers", () => {
  const offered = (number: number, q: string, value: number) => {
    const cycle = cuttingCycles.find((each) => each.number === number);
    if (!cycle) throw new Error(`no cycle ${number}`);
    return shown(typed(exampleJob(cycle), q, value)).map((entry) => [entry.issue.code, entry.at, nearestOf(entry)]);
  };
  expect(offered(831, "Q467", 101)).toEqual([["outOfRange", "Q467", 30]]);
  expect(offered(831, "Q473", -3)).toEqual([["outOfRange", "Q473", 0]]);
  expect(offered(831, "Q473", -1.2)).toEqual([["outOfRange", "Q473", 1.2]]);
  expect(offered(813, "Q495", -1)).toEqual([["outOfRange", "Q495", null]]);
});
