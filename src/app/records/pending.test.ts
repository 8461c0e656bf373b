import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { readPending, storePending } from "./tab.ts";

/** Room for the states of a tab, characters. */
let room = 0;
const kept = new Map<string, string>();

beforeEach(() => {
  kept.clear();
  vi.stubGlobal("sessionStorage", {
    getItem: (name: string) => kept.get(name) ?? null,
    setItem(name: string, text: string) {
      if (text.length > room) throw new DOMException("full", "QuotaExceededError");
      kept.set(name, text);
    },
    removeItem: (name: string) => void kept.delete(name),
  });
});
afterEach(() => vi.unstubAllGlobals());

const state = (work: string, size: number) => ({ work, file: "x".repeat(size) });
const left = () => readPending().map(({ work }) => work);

test("without room for all the largest unsaved states are left out", () => {
  room = 200;
  storePending([state("large", 120), state("small", 10), state("middle", 60)]);
  expect(left()).toEqual(["small", "middle"]);
  room = 60;
  storePending([state("large", 120), state("small", 10), state("middle", 60)]);
  expect(left()).toEqual(["small"]);
});

test("what is left replaces what was left before, and nothing leaves nothing", () => {
  room = 900;
  storePending([state("a", 10), state("b", 10)]);
  storePending([state("c", 10)]);
  expect(left()).toEqual(["c"]);
  storePending([]);
  expect(left()).toEqual([]);
});

test.each(["[1, null, {}]", '[{"work":3,"file":1},{"work":"a"}]', "{", '{"work":"a","file":1}'])(
  "%s is no state",
  (text) => {
    room = 900;
    storePending([state("a", 1)]);
    for (const name of kept.keys()) kept.set(name, text);
    expect(left()).toEqual([]);
  },
);
