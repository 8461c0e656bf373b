import fc from "fast-check";
import { expect, test } from "vitest";
import { AppendList, AppendSet, PersistentMap } from "./persistent.ts";

/** Versions made one from another, each from any that there is, beside plain copies: none may change later. */
function versionsOf<T, U>(empty: readonly [T, U], ways: readonly ((at: readonly [T, U], n: number) => [T, U])[]) {
  const steps = fc.array(fc.tuple(fc.nat(), fc.nat({ max: ways.length - 1 }), fc.nat({ max: 50 })), { maxLength: 120 });
  return steps.map((all) =>
    all.reduce<(readonly [T, U])[]>(
      (versions, [from, way, n]) => {
        // Mostly the newest, so that long ones are made too.
        const version = versions[from % 3 === 0 ? from % versions.length : versions.length - 1] ?? empty;
        return [...versions, ways[way]?.(version, n) ?? version];
      },
      [empty],
    ),
  );
}

test("a list, a set and a map keep what they have, whatever is added to others that were made of them", () => {
  const lists = versionsOf<AppendList<number>, number[]>(
    [new AppendList(), []],
    [
      ([list, plain], n) => [list.with(n), [...plain, n]],
      ([list, plain], n) => [list.withAll([n, n + 1]), [...plain, n, n + 1]],
      ([list, plain]) => [list.withoutLast(), plain.slice(0, -1)],
      ([list, plain]) => (list.all(), [list, plain]),
    ],
  );
  const sets = versionsOf<AppendSet<number>, number[]>(
    [new AppendSet(), []],
    [([set, plain], n) => [set.with(n), plain.includes(n) ? plain : [...plain, n]]],
  );
  const maps = versionsOf<PersistentMap<number, number>, Map<number, number>>(
    [new PersistentMap(), new Map()],
    [
      ([map, plain], n) => [map.with(n, n % 7), new Map([...plain, [n, n % 7]])],
      ([map, plain], n) => [map.with(n, undefined), new Map([...plain].filter(([key]) => key !== n))],
    ],
  );
  fc.assert(
    fc.property(lists, sets, maps, (ofLists, ofSets, ofMaps) => {
      for (const [list, plain] of ofLists)
        expect([list.all(), list.slice(1), list.last, list.length]).toEqual([
          plain,
          plain.slice(1),
          plain.at(-1),
          plain.length,
        ]);
      for (const [set, plain] of ofSets) expect([set.values(), set.has(7)]).toEqual([plain, plain.includes(7)]);
      for (const [map, plain] of ofMaps) {
        expect(map.toMap()).toEqual(plain);
        expect([map.has(7), map.get(7)]).toEqual([plain.has(7), plain.get(7)]);
      }
    }),
    { numRuns: 30 },
  );
});
