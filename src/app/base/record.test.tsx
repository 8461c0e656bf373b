import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { z } from "zod/mini";
import { useNotices } from "./notices.ts";
import { record } from "./record.ts";
import { asideRows, forgetAside } from "./set-aside.ts";

const said: string[] = [];
const lengths = (version = 3) =>
  record({
    key: "lengths",
    version,
    schema: z.object({ mm: z.array(z.number()) }),
    rows: { of: "mm", each: z.number(), most: 3 },
    upgrades: { 1: (all) => all.map((each) => each * 25.4), 2: (all) => all.toReversed() },
    from: ({ mm }): readonly number[] => mm,
    to: (mm) => ({ mm }),
    first: [7.3] as readonly number[],
    say: (trouble) => said.push(trouble),
  });
const kept = () => localStorage.getItem("turnwise/lengths");

beforeEach(() => {
  localStorage.clear();
  useNotices.setState({ notices: [] });
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

test("data of older versions are upgraded step by step; those of a newer one are left alone", () => {
  const here = lengths();
  expect(here.read({ version: 1, mm: [2, 1] })).toEqual([25.4, 50.8]);
  expect(here.read({ version: 2, mm: [2, 1] })).toEqual([1, 2]);
  for (const raw of [{ version: 4, mm: [] }, { version: 0, mm: [] }, { version: 1.5, mm: [] }, { mm: [] }, null])
    expect(here.read(raw)).toBeNull();
  localStorage.setItem("turnwise/lengths", '{"version":4,"mm":[1]}');
  const later = lengths();
  expect(later.now()).toEqual([7.3]);
  later.put([5.5]);
  dispatchEvent(new Event("pagehide"));
  expect([said, kept(), useNotices.getState().notices]).toEqual([["notKept"], '{"version":4,"mm":[1]}', ["newerData"]]);
});

test("damaged data are set aside, beside what was set aside before, and a damaged row without the others", () => {
  localStorage.setItem("turnwise/lengths/damaged", "once [");
  localStorage.setItem("turnwise/lengths", '{"version":3,"mm":[41.7,"x",3.1]}');
  expect(lengths().now()).toEqual([41.7, 3.1]);
  expect([said, kept()]).toEqual([[], '{"version":3,"mm":[41.7,3.1]}']);
  localStorage.setItem("turnwise/lengths", '{"version":3}');
  expect(lengths().now()).toEqual([7.3]);
  expect([said, kept()]).toEqual([["damaged"], null]);
  expect(asideRows().map(({ record: of, name, raw }) => [of, name, raw])).toEqual([
    ["lengths", "lengths", "once ["],
    ["lengths", "1", "x"],
    ["lengths", "lengths", { version: 3 }],
  ]);
  // Beyond the most that are used.
  localStorage.setItem("turnwise/lengths", '{"version":3,"mm":["y",1.1,2.2,3.3,4.4]}');
  expect(lengths().now()).toEqual([1.1, 2.2, 3.3]);
  expect(
    asideRows()
      .slice(3)
      .map(({ name, raw }) => [name, raw]),
  ).toEqual([
    ["0", "y"],
    ["4", 4.4],
  ]);
  asideRows().forEach(() => asideRows().slice(0, 1).forEach(forgetAside));
  expect(Object.keys(localStorage)).toEqual(["turnwise/lengths"]);
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
