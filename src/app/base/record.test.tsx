import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { z } from "zod/mini";
import { record } from "./record.ts";

const said: string[] = [];
const lengths = (version = 3) =>
  record({
    key: "lengths",
    version,
    schema: z.object({ mm: z.array(z.number()) }),
    upgrades: { 1: (all) => all.map((each) => each * 25.4), 2: (all) => all.toReversed() },
    from: ({ mm }): readonly number[] => mm,
    to: (mm) => ({ mm }),
    first: [7.3] as readonly number[],
    say: (trouble) => said.push(trouble),
  });
const kept = () => localStorage.getItem("turnwise/lengths");

beforeEach(() => {
  localStorage.clear();
  said.length = 0;
});
afterEach(() => vi.restoreAllMocks());

test("it starts with the stored value, and each change is stored; the initial value is not", () => {
  localStorage.setItem("turnwise/lengths", '{"version":3,"mm":[41.7,3.1]}');
  const here = lengths();
  expect(here.now()).toEqual([41.7, 3.1]);
  here.put([0.35]);
  dispatchEvent(new Event("pagehide"));
  expect(kept()).toBe('{"version":3,"mm":[0.35]}');
  here.put([7.3]);
  dispatchEvent(new Event("pagehide"));
  expect(kept()).toBeNull();
});

test("data of older versions are upgraded step by step; those of a newer one are set aside and reported", () => {
  const here = lengths();
  expect(here.read({ version: 1, mm: [2, 1] })).toEqual([25.4, 50.8]);
  expect(here.read({ version: 2, mm: [2, 1] })).toEqual([1, 2]);
  for (const raw of [{ version: 4, mm: [] }, { version: 0, mm: [] }, { version: 1.5, mm: [] }, { mm: [] }, null])
    expect(here.read(raw)).toBeNull();
  localStorage.setItem("turnwise/lengths", '{"version":4,"mm":[1]}');
  expect(lengths().now()).toEqual([7.3]);
  expect([said, kept(), localStorage.getItem("turnwise/lengths/damaged")]).toEqual([
    ["damaged"],
    null,
    '{"version":4,"mm":[1]}',
  ]);
});

test("changes of another tab are taken over, also a cleared storage", () => {
  const here = lengths();
  const said = (key: string | null, newValue: string | null) =>
    dispatchEvent(new StorageEvent("storage", { key, newValue, storageArea: localStorage }));
  said("turnwise/lengths", '{"version":3,"mm":[1.1]}');
  said("turnwise/other", '{"version":3,"mm":[9.9]}');
  expect(here.now()).toEqual([1.1]);
  said(null, null);
  expect(here.now()).toEqual([7.3]);
});

test("a full storage is reported; a refused storage is not tried again", () => {
  const here = lengths();
  const set = vi.spyOn(Storage.prototype, "setItem").mockImplementation(() => {
    throw new DOMException("no room", "QuotaExceededError");
  });
  here.put([5.5]);
  dispatchEvent(new Event("pagehide"));
  expect([said, here.use.getState()]).toEqual([["notKept"], { list: [5.5], trouble: "notKept" }]);
  vi.spyOn(Storage.prototype, "getItem").mockImplementation(() => {
    throw new DOMException("refused", "SecurityError");
  });
  const calls = set.mock.calls.length,
    other = lengths();
  other.put([6.6]);
  dispatchEvent(new Event("pagehide"));
  expect([other.now(), set.mock.calls.length, said]).toEqual([[6.6], calls, ["notKept"]]);
});
