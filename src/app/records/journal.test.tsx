import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { ProgramWork, Work } from "../document/work.ts";
import {
  forgetJournal,
  journalWorks,
  leaveJournal,
  noteState,
  noteStored,
  noteTyped,
  readJournal,
  stateAfter,
  writeLarge,
  type Stored,
} from "./journal.ts";
import { SAVE_VERSION } from "./save-file.ts";

const program = (text: string): ProgramWork => ({ name: "P.H", text, encoding: "utf-8" });
const LONG = `0 BEGIN PGM P MM\n${"1 L X+41.7 Z-3.1\n".repeat(20_000)}`;
const at = (savedAt: number, job: Work): Stored => ({ savedAt, job });
const WORKS = ["a", "b", "c"];

/** The state that the next page has of a work whose page is killed now. */
function afterKill(work: string, stored: Stored | null): Work | null {
  const entry = readJournal(work);
  return entry && stateAfter(entry, stored);
}

/** A device that refuses entries beyond a length: one of its two storages, or both. */
const refuse = (longest: number, only?: () => Storage) => {
  const set = Storage.prototype.setItem;
  vi.spyOn(Storage.prototype, "setItem").mockImplementation(function (this: Storage, key: string, text: string) {
    if (text.length > longest && (!only || this === only())) throw new DOMException("no space", "QuotaExceededError");
    set.call(this, key, text);
  });
};

beforeEach(() => {
  for (const work of WORKS) forgetJournal(work);
  localStorage.clear();
  sessionStorage.clear();
});
afterEach(() => vi.restoreAllMocks());

test("each key is on the device at once, as a small difference however large the program is", () => {
  const base = at(5, program(LONG));
  const now = program(LONG.replace("P MM", "P MM ;0.35"));
  expect(noteState("a", now, base)).toBe(true);
  expect(localStorage.getItem("turnwise/journal/a")?.length).toBeLessThan(300);
  expect(afterKill("a", base)).toEqual(now);
  // What a text editor has beyond it.
  noteTyped("a", "P.H", [now.text.length, 0, "2 M30\n"]);
  expect(afterKill("a", base)).toEqual(program(`${now.text}2 M30\n`));
  // The database has it: nothing is left, and what is typed goes on from there.
  noteStored("a", now, at(6, now));
  expect(afterKill("a", at(6, now))).toEqual(program(`${now.text}2 M30\n`));
  noteTyped("a", "P.H", null);
  expect(journalWorks()).toEqual([]);
});

test("while a state is being written, the next page continues from the one before or from it", () => {
  const [base, writing] = [at(5, program("A")), at(7, program("AB"))];
  noteState("a", program("AB"), base, writing);
  noteState("a", program("ABC"), base, writing);
  for (const stored of [base, writing]) expect(afterKill("a", stored)).toEqual(program("ABC"));
  // Another page has stored another state meanwhile, or the entry is of another edition.
  expect(afterKill("a", at(6, program("X")))).toBeNull();
  const entry = readJournal("a");
  expect(entry && stateAfter({ ...entry, version: SAVE_VERSION - 1 }, base)).toBeNull();
});

test("a state of its own is taken where the device has none or an older one", () => {
  noteState("a", program("NEW"), undefined);
  const written = readJournal("a")?.at ?? 0;
  expect(afterKill("a", null)).toEqual(program("NEW"));
  expect(afterKill("a", at(written - 1, program("OLD")))).toEqual(program("NEW"));
  expect(afterKill("a", at(written + 1, program("LATER")))).toBeNull();
});

test("a large entry waits for the end of the page, and goes to the tab; small ones of other works stay", () => {
  expect(noteState("a", program(LONG), undefined)).toBe(false);
  expect(noteState("b", program("B"), undefined)).toBe(true);
  expect(journalWorks()).toEqual(["b"]);
  expect(writeLarge()).toEqual([]);
  expect([Object.keys(localStorage), Object.keys(sessionStorage)]).toEqual([
    ["turnwise/journal/b"],
    ["turnwise/journal/a"],
  ]);
  expect([afterKill("a", null), afterKill("b", null)]).toEqual([program(LONG), program("B")]);
});

test("without space in the tab a large entry goes to the device; without any it alone is named", () => {
  refuse(1000, () => sessionStorage);
  noteState("a", program(LONG), undefined);
  expect([writeLarge(), afterKill("a", null)]).toEqual([[], program(LONG)]);
  vi.restoreAllMocks();
  refuse(1000);
  noteState("c", program(LONG), undefined);
  noteState("b", program("B"), undefined);
  expect([writeLarge(), afterKill("b", null)]).toEqual([["c"], program("B")]);
  // It is asked for again until there is space, or until another tab has the work.
  vi.restoreAllMocks();
  expect([writeLarge(), afterKill("c", null)]).toEqual([[], program(LONG)]);
  leaveJournal("c");
  expect(writeLarge()).toEqual([]);
});

test("while a large first state is written, at least what is typed meanwhile is kept", () => {
  const first = at(5, program(LONG));
  const now = program(`${LONG};end`);
  noteState("a", now, undefined, first);
  expect([afterKill("a", first), afterKill("a", null)]).toEqual([now, null]);
});

test.each([
  "[",
  "{}",
  '{"at":1e300,"version":3,"links":[]}',
  '{"at":1,"version":3,"links":[{"from":5,"by":{"to":7}}]}',
])("the entry %s changes nothing", (text) => {
  localStorage.setItem("turnwise/journal/a", text);
  expect(afterKill("a", at(5, program("A")))).toBeNull();
});
