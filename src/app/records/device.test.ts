import { beforeEach, expect, test, vi } from "vitest";
import { cuttingCycles } from "../../cycles/index.ts";
import { exampleJob } from "../../program/job/job.ts";
import { onLateAnswer } from "../base/database.ts";
import { findWorks, forgetWork, isTaken, keepWork, readUnread, readWork } from "./device.ts";
import { SAVE_VERSION } from "./save-file.ts";

/** Storage in memory: stores by name, an error for every access, and how many values are in memory at once. */
const device = vi.hoisted(() => ({
  stores: new Map<string, Map<string, unknown>>(),
  fault: null as Error | null,
  silent: false,
  late: [] as (() => void)[],
}));
vi.mock("idb-keyval", () => {
  const answer = <T>(work: () => T): Promise<T> =>
    device.silent
      ? new Promise<T>((resolve) => device.late.push(() => resolve(structuredClone(work()))))
      : device.fault
        ? Promise.reject(device.fault)
        : Promise.resolve(structuredClone(work()));
  const of = (name: string) =>
    device.stores.get(name) ?? device.stores.set(name, new Map()).get(name) ?? new Map<string, unknown>();
  return {
    createStore: (name: string) => name,
    entries: (name: string) => answer(() => [...of(name).entries()]),
    keys: (name: string) => answer(() => [...of(name).keys()]),
    get: (key: string, name: string) => answer(() => of(name).get(key)),
    setMany: (all: readonly (readonly [string, unknown])[], name: string) =>
      answer(() => all.forEach(([key, value]) => void of(name).set(key, value))),
    set: (key: string, value: unknown, name: string) => answer(() => void of(name).set(key, value)),
    del: (key: string, name: string) => answer(() => void of(name).delete(key)),
  };
});

const [cycle] = cuttingCycles;
if (!cycle) throw new Error("the catalogue is empty");
const job = exampleJob(cycle);
const works = () => device.stores.get("turnwise-works") ?? new Map<string, unknown>();
const aside = () => device.stores.get("turnwise-damaged") ?? new Map<string, unknown>();

beforeEach(() => {
  device.stores.clear();
  Object.assign(device, { fault: null, silent: false });
});

test("150 works are saved, and all are found, newest first", async () => {
  for (let i = 0; i < 150; i += 1) expect(await keepWork(`w${i}`, { ...job, name: `N${i}` })).toBe("kept");
  works().forEach((file, key) => works().set(key, { ...(file as object), savedAt: Number(key.slice(1)) }));
  device.stores.delete("turnwise-heads");
  const found = await findWorks();
  expect(found).toMatchObject({ available: true, setAside: 0, newer: 0 });
  expect(found.works.map((w) => w.name)).toEqual(Array.from({ length: 150 }, (_, i) => `N${149 - i}`));
  expect(works().size).toBe(150);
  await forgetWork("w7");
  expect((await findWorks()).works.length).toBe(149);
});

test("a list holds no texts of programs", async () => {
  await keepWork("p", { name: "LONG.H", text: "L X+1\n".repeat(100_000), encoding: "utf-8" });
  const found = await findWorks();
  expect(found.works).toEqual([{ work: "p", name: "LONG.H", cycle: null, savedAt: expect.any(Number), size: 600_006 }]);
  expect((await readWork("p"))?.job).toMatchObject({ name: "LONG.H" });
});

test("a work without a name is listed by its first block", async () => {
  await keepWork("p", { name: " ", text: "0 BEGIN PGM BUSH MM\n", encoding: "utf-8" });
  expect((await findWorks()).works.map(({ name }) => name)).toEqual(["BUSH.h"]);
});

test("works of an edition without summaries are found, and read only once", async () => {
  await keepWork("old", { ...job, name: "OLD" }, 41);
  device.stores.delete("turnwise-heads");
  const [found] = (await findWorks()).works;
  expect(found).toMatchObject({ work: "old", name: "OLD", savedAt: 41, cycle: job.cycle });
  works().set("old", { broken: true });
  expect((await findWorks()).works).toEqual([found]);
});

test("a work found damaged when opened is set aside at the next listing", async () => {
  await keepWork("w", job);
  works().set("w", { broken: true });
  expect(await findWorks()).toMatchObject({ setAside: 0, works: [{ work: "w" }] });
  expect(await readWork("w")).toBeNull();
  expect(await findWorks()).toMatchObject({ setAside: 1, works: [] });
  expect([...aside().values()]).toEqual([{ broken: true }]);
});

test("no space and a refusal give different results, and nothing is thrown", async () => {
  device.fault = new DOMException("no room", "QuotaExceededError");
  expect(await keepWork("w", job)).toBe("full");
  device.fault = new DOMException("not allowed", "SecurityError");
  expect(await keepWork("w", job)).toBe("refused");
  expect(await findWorks()).toEqual({ works: [], setAside: 0, newer: 0, unread: [], available: false });
  expect(await readWork("w")).toBeNull();
  await forgetWork("w");
});

test("damaged saves are set aside unchanged, saves of a newer edition stay in place", async () => {
  await keepWork("good", job);
  works().set("broken", { broken: true });
  works().set("newer", { version: SAVE_VERSION + 1, savedAt: 5, job: "of another kind" });
  expect(await findWorks()).toMatchObject({ setAside: 1, newer: 1, works: [{ work: "good" }] });
  expect([...works().keys()].sort()).toEqual(["good", "newer"]);
  expect([...aside().values()]).toEqual([{ broken: true }]);
  const { unread } = await findWorks();
  expect(unread.map(({ store, isNewer }) => [store, isNewer])).toEqual([
    ["damaged", false],
    ["works", true],
  ]);
  expect([await keepWork("newer", job), await readUnread(unread[1]!)]).toMatchObject([
    "newer",
    { version: SAVE_VERSION + 1 },
  ]);
  expect([await isTaken("newer"), await isTaken("good"), await isTaken("free")]).toEqual([true, true, false]);
});

test("saves set aside by an earlier edition that are readable now return under their names and replace no other", async () => {
  await keepWork("mine", { ...job, name: "PRESENT" });
  const old = (name: string) => ({ version: SAVE_VERSION, savedAt: 3, job: { ...job, name } });
  device.stores.set(
    "turnwise-damaged",
    new Map<string, unknown>([
      ["1700000000000 lost", old("LOST")],
      ["1700000000000 mine", old("EARLIER")],
    ]),
  );
  const { works: found } = await findWorks();
  expect(found.map((w) => w.name).sort()).toEqual(["EARLIER", "LOST", "PRESENT"]);
  expect((await readWork("lost"))?.job.name).toBe("LOST");
  expect((await readWork("mine"))?.job.name).toBe("PRESENT");
  expect(aside().size).toBe(0);
});

test("a row whose key is no text gets a name of its own, and hides no work of the same name", async () => {
  await keepWork("42", { ...job, name: "TEXT" });
  works().set(42 as never, { version: SAVE_VERSION, savedAt: 3, job: { ...job, name: "NUMBER" } });
  expect(await findWorks()).toMatchObject({ setAside: 1, works: [{ name: "TEXT" }], unread: [{ name: "NUMBER" }] });
  const { works: found } = await findWorks();
  expect(found.map(({ name }) => name)).toEqual(["TEXT", "NUMBER"]);
  for (const { work, name } of found) expect((await readWork(work))?.job.name).toBe(name);
});

test("a device that never answers counts as one without storage", async () => {
  vi.useFakeTimers();
  device.silent = true;
  const asked = findWorks();
  await vi.runAllTimersAsync();
  expect(await asked).toMatchObject({ works: [], available: false });
  // Nothing else waits once it is known to be silent.
  expect(await keepWork("w", job)).toBe("silent");
  const hear = vi.fn();
  onLateAnswer(hear);
  device.silent = false;
  for (const answer of device.late) answer();
  await vi.runAllTimersAsync();
  expect(hear).toHaveBeenCalled();
  expect(await keepWork("w", job)).toBe("kept");
  vi.useRealTimers();
});
