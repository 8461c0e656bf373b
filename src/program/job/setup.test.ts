import { describe, expect, test } from "vitest";
import { cuttingCycles, cycleByNumber } from "../../cycles/index.ts";
import { ncLabels } from "../../i18n/nc-labels.ts";
import { parse } from "../../nc/parse.ts";
import { simulate } from "../../sim/simulate.ts";
import { exampleJob, UNSET, type Job } from "./job.ts";
import { printJob } from "./print-job.ts";
import { run } from "../run/run.ts";
import { readDraft } from "./read-draft.ts";
import { setupQuestions } from "./setup-questions.ts";
import { otherProposal, setupOf, withSetup } from "./setup.ts";
import { SETUP_PLACES } from "./setup-places.ts";
import { shippedTools } from "../tools/shipped-tools.ts";

const cycleOf = (number: number) => {
  const cycle = cycleByNumber(number);
  if (!cycle) throw new Error(`no cycle ${number}`);
  return cycle;
};
const emptyJob = (number: number, draft: Readonly<Record<string, string>> = {}, rest: Partial<Job> = {}): Job => ({
  ...exampleJob(cycleOf(number)),
  ...UNSET,
  contour: [],
  drafts: { [number]: draft },
  ...rest,
});
const setup = (job: Job) => setupOf(job, shippedTools);
const ran = (job: Job) => {
  const made = run(parse(printJob(withSetup(job, setup(job)), ncLabels("en"))), { tools: shippedTools, rapid: 10_000 });
  return { made, simulation: simulate(made) };
};

describe.each(cuttingCycles.map((cycle) => [cycle.number, cycle] as const))("cycle %i", (number, cycle) => {
  const example = exampleJob(cycle);
  test("with the values of its example is cut in the proposed blank, from the proposed start, with the proposed tool", () => {
    const { made, simulation } = ran({ ...example, ...UNSET });
    // No cylinder is a cone: the material above the crest of a tapered thread is reported.
    const told = made.issues
      .map((found) => found.issue)
      .filter((i) => i.severity !== "info" && (i.code !== "threadMeets" || number === 831));
    expect(told).toEqual([]);
    expect(simulation.findings.map((found) => found.kind)).toEqual([]);
    expect(simulation.proof.cut).toBeGreaterThan(1);
  });
  test("proposes something that can be drawn before the first value", () => {
    const { made } = ran(emptyJob(number));
    expect(made.blank.length).toBeGreaterThan(0);
    const { blank, start, tool } = setup(emptyJob(number));
    expect([blank.outside, start.x].every((typed) => Number(typed) > 0)).toBe(true);
    // Longer than the clamping length.
    expect(Number(blank.length)).toBeGreaterThan(32);
    expect(shippedTools.some(({ T }) => T === tool)).toBe(true);
  });
});

test("a groove from 0 to -12 gets a blank whose face is where it starts, and is cut in it", () => {
  const draft = { ...exampleJob(cycleOf(852)).drafts[852], Q491: "61.3", Q492: "0", Q493: "42.7", Q494: "-12" };
  const { blank, start } = setup(emptyJob(852, draft));
  expect(blank).toEqual({ outside: "83", bore: "0", length: "42", allowance: "0" });
  expect(start).toEqual({ x: "61.3", z: "2" });
  const { made, simulation } = ran(emptyJob(852, draft));
  expect(made.issues.filter((found) => found.issue.severity === "error")).toEqual([]);
  expect([simulation.findings.length, simulation.proof.cut > 50]).toEqual([0, true]);
});

test("each typed value updates the proposals; set fields stay and update the rest", () => {
  const at = (draft: Readonly<Record<string, string>>, rest: Partial<Job> = {}) => setup(emptyJob(812, draft, rest));
  expect(at({ Q491: "61.3" }).blank).toMatchObject({ outside: "61.3", allowance: "0" });
  expect(at({ Q491: "61.3", Q492: "1.5", Q493: "40", Q494: "-33.2" })).toMatchObject({
    blank: { outside: "61.3", bore: "0", length: "65", allowance: "1.5" },
    start: { x: "61.3", z: "3.5" },
  });
  const set = at(
    { Q491: "61.3", Q492: "0", Q494: "-33.2" },
    { blank: { outside: "66", bore: "", length: "", allowance: "2.2" } },
  );
  expect([set.blank.outside, set.start.x, set.start.z]).toEqual(["66", "66", "4.2"]);
  expect([...set.proposed].toSorted()).toEqual(["blank.bore", "blank.length", "start.x", "start.z", "tool"]);
  expect(set.proposal.blank.outside).toBe("61.3");
});

test("a bore gets a hollow blank, a start inside it and a tool that points outwards", () => {
  const { blank, start, tool } = setup(emptyJob(812, { Q491: "30.4", Q492: "0", Q493: "47.1", Q494: "-21" }));
  expect(blank).toMatchObject({ outside: "68", bore: "30.4" });
  expect(start).toEqual({ x: "30.4", z: "2" });
  expect(shippedTools.find(({ T }) => T === tool)?.TO).toBe(7);
});

test("a half-typed number changes nothing that depends on it", () => {
  const typed = { Q491: "61.3", Q492: "0", Q493: "40" };
  for (const half of ["-", "+", "2*", "("])
    expect(setup(emptyJob(812, { ...typed, Q494: half }))).toEqual(setup(emptyJob(812, typed)));
});

test("material in front of the face is not proposed for an end that was typed without its minus", () => {
  const { blank } = setup(emptyJob(812, { Q491: "61.3", Q492: "0", Q493: "40", Q494: "55" }));
  expect(blank).toMatchObject({ length: "85", allowance: "0" });
});

describe("another proposal for a set field", () => {
  const shoulder = { Q491: "61.3", Q492: "0", Q493: "40", Q494: "-33.2" };
  test.each(cuttingCycles.map((cycle) => [cycle.number, cycle] as const))("none in example %i", (_, cycle) => {
    expect(SETUP_PLACES.map((place) => otherProposal(exampleJob(cycle), place, shippedTools))).toEqual(
      SETUP_PLACES.map(() => null),
    );
  });
  const set = { blank: { ...UNSET.blank, outside: "60" }, tool: 1 };
  test.each<[string, Partial<Job>, "blank.outside" | "tool", string | null]>([
    ["the proposal has changed", { ...set, proposals: { "blank.outside": "60" } }, "blank.outside", "61.3"],
    ["it is as it was", { ...set, proposals: { "blank.outside": "61.3" } }, "blank.outside", null],
    ["it is not known what was proposed", set, "blank.outside", null],
    ["it is empty", { proposals: { "blank.outside": "60" } }, "blank.outside", null],
    [
      "it is what is set",
      { blank: { ...UNSET.blank, outside: "61.30" }, proposals: { "blank.outside": "60" } },
      "blank.outside",
      null,
    ],
    ["another tool that suits the contour", { ...set, tool: 2 }, "tool", null],
    ["a tool that does not", { ...set, tool: 10 }, "tool", "1"],
  ])("%s", (_, rest, place, other) => {
    expect(otherProposal(emptyJob(812, shoulder, rest), place, shippedTools)).toBe(other);
  });
});

describe("questions where values and set-up do not agree", () => {
  const asked = (job: Job) => {
    const s = setup(job);
    const cycle = cycleOf(job.cycle);
    const { partial } = readDraft(cycle, job.drafts[job.cycle] ?? {});
    return setupQuestions({ cycle, job: withSetup(job, s), setup: s, partial, tools: shippedTools }).map(
      ({ code, at, data }) => [code, at, data],
    );
  };
  const shoulder = { Q491: "61.3", Q492: "0", Q493: "40", Q494: "-33.2" };

  test.each(cuttingCycles.map((cycle) => [cycle.number, cycle] as const))(
    "none of the example of cycle %i",
    (_, cycle) => {
      expect(asked(exampleJob(cycle))).toEqual([]);
    },
  );
  test.each<[string, Readonly<Record<string, string>>, Partial<Job>]>([
    ["a contour that begins in front of the face", { ...shoulder, Q492: "2" }, {}],
    ["a datum far behind", { ...shoulder, Q492: "120.5", Q494: "70" }, {}],
    ["an end that is not answered yet", { Q491: "61.3", Q494: "55" }, {}],
    ["a tool that works away from the chuck", { ...shoulder, Q492: "-60", Q494: "21" }, { tool: 7 }],
    [
      "a blank that reaches there",
      { ...shoulder, Q494: "33.2" },
      { blank: { ...UNSET.blank, length: "100", allowance: "40" } },
    ],
  ])("none about %s", (_, draft, rest) => expect(asked(emptyJob(812, draft, rest))).toEqual([]));

  test("an end in front of its start raises a question about its minus sign", () => {
    expect(asked(emptyJob(812, { ...shoulder, Q494: "55.4" }))).toEqual([
      ["endInFront", "Q494", { value: 55.4, nearest: -55.4 }],
    ]);
  });
  test.each([
    ["is questioned", {}, [["endsExchanged", "Q492", { axis: "Z", start: -35, end: -10, other: "Q494" }]]],
    ["is right with a start point behind it", { start: { ...UNSET.start, z: "-37" } }, []],
  ])("an order away from the chuck %s", (_, rest, found) =>
    expect(asked(emptyJob(812, { ...shoulder, Q492: "-35", Q494: "-10" }, rest))).toEqual(found),
  );
  test.each<[number, Readonly<Record<string, string>>, Partial<Job["blank"]>, string, object]>([
    [
      812,
      shoulder,
      { outside: "60" },
      "blank.outside",
      { place: "outside", contour: 61.3, blank: 60, other: "Q491", nearest: 61.3 },
    ],
    [
      812,
      shoulder,
      { length: "30" },
      "blank.length",
      { place: "length", contour: -33.2, blank: -30, other: "Q494", nearest: 64 },
    ],
    [
      852,
      { Q491: "61.3", Q492: "0", Q493: "42.7", Q494: "-12" },
      { allowance: "-20" },
      "blank.allowance",
      {
        place: "allowance",
        contour: 0,
        blank: -20,
        other: "Q492",
        nearest: 0,
      },
    ],
    [
      812,
      { ...shoulder, Q491: "30", Q493: "41.5" },
      { bore: "43" },
      "blank.bore",
      {
        place: "bore",
        contour: 41.5,
        blank: 43,
        other: "Q493",
        nearest: 30,
      },
    ],
    [
      831,
      { Q471: "0", Q491: "20", Q492: "0", Q494: "-15" },
      { outside: "75" },
      "blank.outside",
      {
        place: "thread",
        contour: 20,
        blank: 75,
        other: "Q491",
        nearest: 20,
      },
    ],
  ])("cycle %i with %j in %j is asked about", (number, draft, blank, at, data) => {
    expect(asked(emptyJob(number, draft, { blank: { ...UNSET.blank, ...blank } }))).toEqual([
      ["blankAgainstContour", at, data],
    ]);
  });
});
