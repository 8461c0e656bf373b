import { expect, test } from "vitest";
import {
  AT_REST,
  plansOnPage,
  progressOf,
  type Calculation,
  type CalculationEvent,
  type Effect,
  type Wait,
  type CalculationInput,
} from "./calculation-state.ts";
import type { Outcome, Planned, Stage } from "./outcome.ts";
import { reduce } from "./reducer.ts";

/** An event, and its effects in words. */
type Row = readonly [event: CalculationEvent, effects?: string];

const SHORT = "L X+3.5\n";
const LONG = "CYCL CALL\n".repeat(2400);
const HUGE = "L X+1.25\n".repeat(120_000);
const table = { tools: [], mills: [], refused: new Map() };

const edit = (
  text: string | null = SHORT,
  more: Partial<CalculationInput> & { again?: boolean } = {},
): CalculationEvent => ({
  event: "edited",
  of: "flange",
  isVeiled: false,
  request: text === null ? null : { text, table, rapid: 9300, control: "TNC7" },
  ...more,
});
const key = (digit: string, text = SHORT) => edit(`${text}; ${digit}\n`);
const made = (version: number, pace?: number): Planned =>
  ({ version, text: "", run: {}, simulation: null, ...(pace !== undefined && { pace }) }) as unknown as Planned;
const planned = (version: number, took = 1.3, what: Planned | "part" | null = made(version)): CalculationEvent => ({
  event: "planned",
  version,
  made: what,
  took,
});
/** `pace`: time of the run, if the worker made it. */
const proved = (version: number, pace?: number): CalculationEvent => ({
  event: "proved",
  version,
  outcome: made(version, pace) as unknown as Outcome,
});
const rested = (from: Wait): CalculationEvent => ({ event: "rested", from });
const at = <Of extends Stage | null>(stage: Of) => ({ stage, share: stage === "proving" ? 0.5 : 0 });
const began = (version: number, stage: Stage): CalculationEvent => ({ event: "began", version, ...at(stage) });
const cancelled: CalculationEvent = { event: "cancelled" };
const left: CalculationEvent = { event: "left" };

function inWords(effect: Effect): string {
  if ("on" in effect) {
    const { order } = effect;
    const { version, text } = order.request;
    if (order.do === "prove") {
      const what = order.planned ? "run of " : text === HUGE || text.length < 30_000 ? "" : "beginning of ";
      return `${effect.on} proves ${what}${version}`;
    }
    const { part } = order;
    if (part === "whole") return `${effect.on} plans ${version}`;
    return `${effect.on} plans ${"share" in part ? part.share : `${part.slice} ms`} of ${version}`;
  }
  switch (effect.do) {
    case "show":
      if ("planned" in effect) return `path ${effect.planned.version} ${effect.as}`;
      return `${effect.isBeginning ? "beginning" : "result"} ${effect.outcome.version}`;
    case "wait":
      return `wait for ${effect.for}${effect.ms === undefined ? "" : ` ${effect.ms}`}`;
    default:
      return effect.do;
  }
}
function after(events: readonly CalculationEvent[], begin: Calculation = AT_REST): Calculation {
  return events.reduce((state, event) => reduce(state, event)[0], begin);
}

function played(rows: readonly Row[], begin: readonly CalculationEvent[]): readonly string[] {
  let state = after(begin);
  return rows.map(([event]) => {
    const [next, effects] = reduce(state, event);
    state = next;
    return effects.map(inWords).join(", ");
  });
}

const HERE = rested("planner");
/** A short work is open, planned on the page and checked. */
const OPEN = [HERE, edit(), planned(1), rested("picture"), proved(1)];
/** Two plans of it were slow. */
const SLOW = [...OPEN, key("3"), planned(2, 61.2), key("4"), planned(3, 60.7), rested("picture"), proved(3)];
/** The page has planned a key, and the worker checks it. */
const PROVING = [...OPEN, key("3"), planned(2), rested("picture")];
/** A long work is open and not yet planned on the page. */
const LONG_OPEN = [HERE, edit(LONG), planned(1), proved(1, 1311.4)];

test.each<[what: string, begin: readonly CalculationEvent[], rows: readonly Row[]]>([
  [
    "before the page can plan the worker makes run and proof at once",
    [],
    [[edit(), "worker proves 1"], [began(1, "running")], [proved(1, 9.4), "result 1"]],
  ],
  [
    "a quick text is planned on the page at once, and checked with that run after its frame",
    [HERE],
    [
      [edit(), "page plans 1"],
      [planned(1), "path 1 now, wait for picture"],
      [rested("picture"), "worker proves run of 1"],
      [proved(1), "result 1"],
      [key("3"), "page plans 2"],
    ],
  ],
  ["nothing is calculated twice, except on request", OPEN, [[edit()], [edit(SHORT, { again: true }), "page plans 2"]]],
  [
    "another table of tools is another calculation of the same text",
    OPEN,
    [[edit(SHORT, { request: { text: SHORT, table: { ...table }, rapid: 9300, control: "TNC7" } }), "page plans 2"]],
  ],
  [
    "while the worker is at one text only the newest of the others waits",
    [],
    [
      [edit(), "worker proves 1"],
      [key("3")],
      [key("37")],
      [proved(1, 9.4), "result 1, worker proves 3"],
      [proved(3, 9.2), "result 3"],
    ],
  ],
  [
    "a proof that comes when more was planned is shown, and the newer path is proved next",
    PROVING,
    [
      [key("37"), "page plans 3"],
      [planned(3), "path 3 now, wait for picture"],
      [proved(2), "result 2, worker proves run of 3"],
      [rested("picture")],
      [proved(3), "result 3"],
    ],
  ],
  [
    "a plan that fails on the page is made by the worker, which says so",
    OPEN,
    [
      [key("3"), "page plans 2"],
      [planned(2, 1.3, null), "worker proves 2"],
      [{ event: "failed", version: 2 }, "sayFailed, stopWorker"],
    ],
  ],
  [
    "when the worker fails, the queued text goes to a new one",
    [edit(), key("3")],
    [
      [{ event: "failed", version: 1 }, "sayFailed, stopWorker, worker proves 2"],
      [{ event: "failed", version: 1 }],
      [proved(2, 9.4), "result 2"],
    ],
  ],
  [
    "the late answer of a closed work is ignored",
    [edit()],
    [
      [left, "forget, wait for leftWork 400"],
      [left, "forget"],
      [proved(1, 9.4)],
      [edit("M30\n", { of: "shaft" }), "worker proves 2"],
      [rested("leftWork")],
      [proved(2, 9.4), "result 2"],
    ],
  ],
  [
    "another work closes the previous one, which is given up after a time limit",
    [edit()],
    [
      [edit("M30\n", { of: "shaft" }), "forget, wait for leftWork 400"],
      [rested("leftWork"), "stopWorker, worker proves 2"],
      [proved(1, 9.4)],
      [proved(2, 9.4), "result 2"],
    ],
  ],
  [
    "a work that is closed while its path is only planned is not checked",
    [edit(HUGE), left],
    [[proved(1, 9.4)], [planned(1)]],
  ],
  [
    "incomplete values drop the queued text, which is calculated when the same values come again",
    [edit(), key("3")],
    [[edit(null)], [proved(1, 9.4), "result 1"], [key("3"), "worker proves 3"]],
  ],
  [
    "a result from before values were emptied is kept for when they come again",
    OPEN,
    [[edit(null)], [edit()], [key("3"), "page plans 2"]],
  ],
  [
    "a work that still needs a fetch is not calculated, but the previous work is closed",
    OPEN,
    [[{ event: "edited", of: "shaft", isVeiled: false }, "forget"]],
  ],
  [
    "stopped by the operator, nothing continues, and late answers are ignored",
    [edit(), key("3")],
    [[cancelled, "stopWorker"], [proved(1, 9.4)], [key("3")], [edit(SHORT, { again: true }), "worker proves 3"]],
  ],
  [
    "a result waits for a pause in typing, and the next text for the result",
    PROVING,
    [
      [{ event: "typed", pause: 150 }, "wait for quiet 150"],
      [proved(2)],
      [key("37"), "page plans 3"],
      [planned(3), "path 3 now, wait for picture"],
      [rested("picture")],
      [rested("quiet"), "result 2, worker proves run of 3"],
      [proved(3), "result 3"],
    ],
  ],
  [
    "a result that waits is dropped with its work, and its worker is not stopped",
    [edit(), { event: "typed", pause: 150 }, proved(1, 9.4)],
    [[left, "forget"], [rested("quiet")], [edit("M30\n", { of: "shaft" }), "worker proves 2"]],
  ],
  [
    "an exercise that asks for a prediction is never planned where it could be seen",
    [HERE],
    [
      [edit(SHORT, { isVeiled: true }), "worker proves 1"],
      [proved(1, 9.3), "result 1, wait for rest"],
      [edit(LONG, { isVeiled: true }), "worker proves 2"],
    ],
  ],
  [
    "after two slow plans the digit is drawn first, and of several in a row only the last is planned",
    SLOW,
    [
      [key("5"), "wait for digit"],
      [key("51"), "wait for digit"],
      [rested("digit"), "page plans 5"],
      [planned(5, 61.9), "path 5 typed, wait for picture"],
      [rested("digit")],
      [rested("picture"), "worker proves run of 5"],
    ],
  ],
  [
    "a text that waits for a digit is dropped with its work, with its values, and when stopped",
    [...SLOW, key("5")],
    [[edit(null)], [rested("digit")], [key("5"), "wait for digit"], [cancelled], [rested("digit")]],
  ],
  [
    "a slow text is planned by the worker, and shown before it is checked",
    [HERE],
    [
      [edit(LONG), "worker plans 1"],
      [planned(1), "path 1 byItself, worker proves run of 1"],
      [proved(1, 1311.4), "result 1, wait for rest"],
    ],
  ],
  [
    "a text typed while a slow one is planned comes next, and only that is checked",
    [HERE, edit(LONG)],
    [
      [key("3", LONG)],
      [planned(1), "path 1 byItself, worker plans 2"],
      [planned(2), "path 2 byItself, worker proves run of 2"],
    ],
  ],
  [
    "a huge text shows its beginning while there is nothing else",
    [],
    [
      [edit(HUGE), "worker proves beginning of 1"],
      [proved(1, 20.3), "beginning 1, worker plans 1"],
      [planned(1), "path 1 byItself, worker proves run of 1"],
      [proved(1, 4100), "result 1"],
      [key("3", HUGE), "worker plans 2"],
    ],
  ],
  [
    "an opened work is planned while idle, once: share by share, the last time cached",
    [HERE, edit(LONG.slice(0, 9000)), planned(1, 1.3, null)],
    [
      [proved(1, 211.4), "result 1, wait for rest"],
      [rested("rest"), "page plans 0.25 of 1"],
      [planned(1, 590), "wait for rest"],
      [rested("rest"), "page plans 0.5 of 1"],
      [planned(1, 12), "wait for rest"],
      [rested("rest"), "page plans 0.75 of 1"],
      [planned(1, 8), "wait for rest"],
      [rested("rest"), "page plans 1 of 1"],
      [planned(1, 7), "wait for rest"],
      [rested("rest"), "page plans 1"],
      [planned(1, 6)],
      [rested("rest")],
      [key("3"), "page plans 2"],
      [planned(2, 6, null), "worker proves 2"],
      [proved(2, 9.7), "result 2"],
    ],
  ],
  [
    "planning ahead ends with a part that is slow or fails",
    [HERE, edit(), planned(1, 1.3, null), proved(1, 211.4)],
    [[rested("rest"), "page plans 0.25 of 1"], [planned(1, 601)], [rested("rest")]],
  ],
  ["a slow work is not planned ahead", [HERE, edit(LONG), planned(1)], [[proved(1, 4001), "result 1"]]],
  [
    "a work is planned ahead as soon as the page can plan",
    [edit(), proved(1, 211.4)],
    [
      [HERE, "wait for rest"],
      [rested("rest"), "page plans 0.25 of 1"],
    ],
  ],
  [
    "a long text is planned slice by slice while idle, and on the page from then on",
    LONG_OPEN,
    [
      [rested("rest"), "page plans 6 ms of 1"],
      [planned(1, 6.1, "part"), "wait for rest"],
      [rested("rest"), "page plans 6 ms of 1"],
      [planned(1, 3.2), "prepare"],
      [rested("rest")],
      [key("3", LONG), "page plans 2"],
    ],
  ],
  [
    "before that, a long text is planned in slices, and the page answers in between",
    LONG_OPEN.with(-1, proved(1, 1311.4)),
    [
      [key("3", LONG), "wait for slice"],
      [rested("rest")],
      [rested("slice"), "page plans 20 ms of 2"],
      [planned(2, 20.4, "part"), "wait for slice"],
      [key("37", LONG), "wait for slice"],
      [rested("slice"), "page plans 20 ms of 3"],
      [planned(3, 11.2), "path 3 typed, wait for picture, prepare"],
      [rested("picture"), "worker proves run of 3"],
      [key("4", LONG), "page plans 4"],
    ],
  ],
  [
    "until then a long text with a slow first run is planned by the worker",
    [HERE, edit(LONG), planned(1), proved(1, 1511.4)],
    [[key("3", LONG), "worker plans 2"]],
  ],
])("%s", (_, begin, rows) => {
  expect(played(rows, begin)).toEqual(rows.map(([, effects = ""]) => effects));
});

test.each<[what: string, events: readonly CalculationEvent[], stage: Stage | null, stopped: boolean, paused: boolean]>([
  ["nothing is open", [], null, false, false],
  ["the worker reads", [edit()], "reading", false, false],
  ["the worker proves", [edit(), began(1, "proving")], "proving", false, false],
  ["a path waits for its picture", [HERE, edit(), planned(1)], "reading", false, false],
  ["a planned text is not run again", [...PROVING, began(2, "running")], "reading", false, false],
  ["the check of a planned text begins", [...PROVING, began(2, "proving")], "proving", false, false],
  ["a digit is drawn first", [...SLOW, key("5")], "reading", false, false],
  ["all is proved", OPEN, null, false, false],
  ["the worker calculates a closed work", [edit(), left], null, false, false],
  ["the next one waits for it", [edit(), edit("M30\n", { of: "shaft" })], "reading", false, false],
  ["the operator stopped it", [edit(), cancelled], null, true, false],
  ["it goes on", [edit(), cancelled, edit(SHORT, { again: true })], "reading", false, false],
  ["it failed", [edit(), { event: "failed", version: 1 }], null, true, false],
  ["the calculation of a closed work failed", [edit(), left, { event: "failed", version: 1 }], null, false, false],
  ["values are missing", [...OPEN, edit(null)], null, false, true],
  ["they are there again", [...OPEN, edit(null), edit()], null, false, false],
])("the shown progress when %s", (_, events, stage, stopped, paused) => {
  expect(progressOf(after(events))).toEqual({ ...at(stage), stopped, paused });
});

test("another work has a pace of its own", () => {
  const events = [HERE, edit(LONG), planned(1), proved(1, 9.6)];
  expect(plansOnPage(after(events), 20_001)).toBe(true);
  expect(plansOnPage(after([...events, left]), 20_001)).toBe(false);
});
