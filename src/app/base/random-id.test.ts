import { afterEach, describe, expect, test, vi } from "vitest";
import { randomId, seedOf } from "./random-id.ts";

const UUID = /^[0-9a-f]{8}-[0-9a-f]{4}-4[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}$/;

/** A device with empty storage, opened at this address. */
function freshDevice(search: string, { refuses = false } = {}): void {
  const kept = new Map<string, string>();
  vi.stubGlobal("location", { search });
  vi.stubGlobal("localStorage", {
    getItem: (key: string) => kept.get(key) ?? null,
    setItem: (key: string, value: string) => {
      if (refuses) throw new Error("full");
      kept.set(key, value);
    },
  });
}
/** The module as a newly loaded page imports it. */
const opened = async (): Promise<typeof randomId> => {
  vi.resetModules();
  return (await import("./random-id.ts")).randomId;
};
const drawn = (draw: () => string, count: number) => Array.from({ length: count }, draw);

afterEach(() => vi.unstubAllGlobals());

describe("with a seed", () => {
  test("a fresh device draws the same names in every run, and others with another seed", async () => {
    freshDevice("?clock=manual&seed=7");
    const first = drawn(await opened(), 40);
    freshDevice("?seed=7");
    const again = drawn(await opened(), 40);
    freshDevice("?seed=8");
    const other = drawn(await opened(), 40);
    expect(again).toEqual(first);
    expect(new Set([...first, ...other]).size).toBe(80);
    for (const id of first) expect(id).toMatch(UUID);
  });
  test("a reload continues the sequence of the previous page, so that no name repeats", async () => {
    freshDevice("?seed=7");
    const names = [...drawn(await opened(), 5), ...drawn(await opened(), 5)];
    expect(new Set(names).size).toBe(10);
    freshDevice("?seed=7");
    expect(drawn(await opened(), 10)).toEqual(names);
  });
  test("no name repeats on a page without storage", async () => {
    freshDevice("?seed=7", { refuses: true });
    expect(new Set(drawn(await opened(), 20)).size).toBe(20);
  });
});

test("without a seed every name is new, also in a worker or on Node", () => {
  const names = drawn(randomId, 50);
  expect(new Set(names).size).toBe(50);
  for (const id of names) expect(id).toMatch(UUID);
});

test.each([
  ["", null],
  ["?seed=7", 7],
  ["?seed=", null],
  ["?seed=x", null],
  ["?seed=-1", null],
  ["?seed=4294967299", 3],
])("seed of %j", (search, seed) => expect(seedOf(search)).toBe(seed));
