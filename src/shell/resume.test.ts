import { beforeEach, expect, test, vi } from "vitest";
import { resume, type AskedWork } from "./resume.ts";

/** What the device, the tab and the other tabs have. */
interface Given {
  readonly remembered?: string | null;
  readonly taken?: readonly string[];
  readonly gone?: readonly string[];
  readonly pending?: readonly { readonly work: string; readonly file: unknown }[];
  readonly died?: string;
  readonly available?: boolean;
  readonly newer?: number;
}
const WORKS = [
  { work: "new", name: "NEW" },
  { work: "old", name: "OLD" },
];
const SAVED: Readonly<Record<string, number>> = { new: 20, old: 10 };

/** What the page does, in words, and what it does it with. */
const page = vi.hoisted(() => {
  const told: string[] = [];
  const word = (each: unknown): string =>
    each === null ? "none" : typeof each === "object" ? Object.values(each).join("/") : String(each);
  const tell =
    (name: string) =>
    (...values: readonly unknown[]) =>
      void told.push([name, ...values.map(word)].join(" "));
  return { told, tell, given: {} as Given };
});
const { told } = page;

vi.mock("../app/document/store.ts", () => ({
  openFirstWork: (job: unknown, work: unknown) => page.tell("open")(work, job),
}));
vi.mock("../app/records/device.ts", () => ({
  findWorks: () =>
    Promise.resolve({
      works: WORKS,
      setAside: 0,
      available: page.given.available ?? true,
      newer: page.given.newer ?? 0,
    }),
  readWork: (work: string) =>
    Promise.resolve(
      work in SAVED && !page.given.gone?.includes(work) ? { job: `job-${work}`, savedAt: SAVED[work] } : null,
    ),
}));
vi.mock("../app/place/place.ts", () => ({ showElsewhere: page.tell("elsewhere") }));
vi.mock("../app/base/notices.ts", () => ({ notice: page.tell("notice") }));
vi.mock("../app/records/keep.ts", () => ({
  keepState: page.tell("keep"),
  settleJournals: page.tell("journals"),
  showFound: page.tell("list"),
  noteWritten: () => undefined,
  useSavedWorks: {
    getState: () => ({ works: WORKS }),
    setState: ({ ready }: { readonly ready?: boolean }) => ready && page.tell("ready")(),
  },
}));
vi.mock("../app/records/opening.ts", () => ({
  diedOpen: (work: string) => page.given.died === work,
  noteOpening: page.tell("mark"),
}));
vi.mock("../app/records/save-file.ts", () => ({ readSave: (raw: unknown) => raw }));
vi.mock("../app/records/tab.ts", () => ({
  claimWithRetries: (work: string) => Promise.resolve(!page.given.taken?.includes(work)),
  takePending: () => page.given.pending ?? [],
  rememberedWork: () => page.given.remembered ?? null,
  rememberWork: page.tell("remember"),
}));

beforeEach(() => void told.splice(0));

const OPENS = (work: string) => [`mark ${work}`, `remember ${work}`, `open ${work} job-${work}`];
const START = ["open none none"];

test.each<[string, AskedWork, Given, readonly string[]]>([
  ["a new tab: the newest", undefined, {}, OPENS("new")],
  ["the work last open in this tab", undefined, { remembered: "old" }, OPENS("old")],
  ["the start page was last open", undefined, { remembered: "" }, ["remember none", ...START]],
  ["the work last open was deleted", undefined, { remembered: "lost" }, ["remember none", ...START]],
  ["the address asks for a work", "old", { remembered: "new" }, OPENS("old")],
  ["the address asks for the start page", null, { remembered: "old" }, ["remember none", ...START]],
  ["the address asks for a work that is not here", "lost", {}, ["notice workNotHere", "remember none", ...START]],
  ["another tab has it", "old", { taken: ["old"] }, [...START, "elsewhere old/OLD/isOpen"]],
  ["it cannot be read", "old", { gone: ["old"] }, START],
  ["the page before died over it", "old", { died: "old" }, [...START, "elsewhere old/OLD/died"]],
  ["the page before died over another", "old", { died: "new" }, OPENS("old")],
  ["something of a newer edition is here", "old", { newer: 1 }, ["notice newerWorks", ...OPENS("old")]],
  ["nothing can be kept here", null, { available: false, newer: 2 }, ["notice notKept", ...START]],
])("the page begins with: %s", async (_, asked, own, expected) => {
  page.given = own;
  await resume(asked);
  expect(told[0]).toBe("journals");
  expect(told[1]).toMatch(/^list/);
  expect(told.slice(2)).toEqual([...expected, "ready"]);
});

test.each<[string, unknown, readonly string[]]>([
  ["newer than what is kept", { job: "typed", savedAt: 21 }, ["keep new typed"]],
  ["as new as what is kept", { job: "typed", savedAt: 20 }, ["keep new typed"]],
  ["older than what is kept", { job: "typed", savedAt: 19 }, []],
  ["damaged", null, []],
])("what a page of an earlier edition could not save is saved before the journals: %s", async (_, file, expected) => {
  page.given = { pending: [{ work: "new", file }] };
  await resume(null);
  expect(told.slice(0, expected.length + 1)).toEqual([...expected, "journals"]);
});
