import { afterEach, expect, test, vi } from "vitest";
import { claimWork, releaseWork, worksInOtherTabs } from "./tab.ts";

/** Locks as in browsers: released, and reported, a moment after they are let go. */
function browserLocks(elsewhere: readonly string[]) {
  const held = new Set(elsewhere);
  return {
    async request(name: string, _options: unknown, hold: (lock: unknown) => unknown) {
      if (held.has(name)) return void (await hold(null));
      held.add(name);
      await hold({ name });
      await new Promise((done) => setTimeout(done, 5));
      held.delete(name);
    },
    async query() {
      const told = [...held].map((name) => ({ name }));
      await new Promise((done) => setTimeout(done, 1));
      return { held: told };
    },
  };
}

afterEach(() => vi.unstubAllGlobals());

test("a work that this tab is releasing is not open elsewhere, one that another tab has is", async () => {
  vi.stubGlobal("navigator", { locks: browserLocks(["turnwise B"]) });
  expect([await claimWork("A"), await claimWork("B")]).toEqual([true, false]);
  const asked = worksInOtherTabs();
  releaseWork("A");
  expect([...(await asked)]).toEqual(["B"]);
  expect([...(await worksInOtherTabs())]).toEqual(["B"]);
});

test("a work that was released and claimed by another tab is open there", async () => {
  const locks = browserLocks([]);
  vi.stubGlobal("navigator", { locks });
  await claimWork("C");
  releaseWork("C");
  await vi.waitFor(async () => expect((await locks.query()).held).toEqual([]));
  void locks.request("turnwise C", {}, () => new Promise(() => undefined));
  expect([...(await worksInOtherTabs())]).toEqual(["C"]);
});
