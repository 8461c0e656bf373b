import { beforeEach, expect, test, vi } from "vitest";
import { resume, type AskedWork } from "./resume.ts";

/** What the device, the tab and the other tabs have. */
interface Given {
  readonly remembered?: string | null;
  readonly taken?: readonly string[];
  readonly gone?: readonly string[];
  readonly pending?: readonly { readonly work: string; readonly file: unknown }[];
  readonly isFull?: boolean;
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
  claimWithRetries: (work: string) => Promise.resolve(!page.given.taken?.includes(work)),
  keepState: page.tell("keep"),
  noteWritten: () => undefined,
  unsavedWorks: () => (page.given.isFull ? ["some"] : []),
  useSavedWorks: { setState: ({ ready }: { readonly ready?: boolean }) => ready && page.tell("ready")() },
}));
vi.mock("../app/records/save-file.ts", () => ({ readSave: (raw: unknown) => raw }));
vi.mock("../app/records/tab.ts", () => ({
  readPending: () => page.given.pending ?? [],
  storePending: (states: readonly unknown[]) => page.tell("pending")(states.length),
  rememberedWork: () => page.given.remembered ?? null,
  rememberWork: page.tell("remember"),
}));

beforeEach(() => void told.splice(0));

const OPENS = (work: string) => [`remember ${work}`, `open ${work} job-${work}`];
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
  [
    "nothing can be kept here",
    null,
    { available: false, newer: 2 },
    ["notice notKept", "notice newerWorks", "remember none", ...START],
  ],
])("the page begins with: %s", async (_, asked, own, expected) => {
  page.given = own;
  await resume(asked);
  expect(told).toEqual(["pending 0", ...expected, "ready"]);
});

test.each<[string, Given, readonly string[]]>([
  [
    "newer than what is kept",
    { pending: [{ work: "new", file: { job: "typed", savedAt: 21 } }] },
    ["keep new typed", "pending 0"],
  ],
  [
    "as new as what is kept",
    { pending: [{ work: "new", file: { job: "typed", savedAt: 20 } }] },
    ["keep new typed", "pending 0"],
  ],
  ["older than what is kept", { pending: [{ work: "new", file: { job: "typed", savedAt: 19 } }] }, ["pending 0"]],
  [
    "of a work that was never kept",
    { pending: [{ work: "third", file: { job: "typed", savedAt: 1 } }] },
    ["keep third typed", "pending 0"],
  ],
  ["damaged", { pending: [{ work: "new", file: null }] }, ["pending 0"]],
  [
    "still without room: it stays for the next page",
    { isFull: true, pending: [{ work: "new", file: { job: "typed", savedAt: 21 } }] },
    ["keep new typed"],
  ],
])("what the page before could not save is saved now: %s", async (_, own, expected) => {
  page.given = own;
  await resume(null);
  expect(told.slice(0, expected.length)).toEqual(expected);
  expect(told.filter((each) => /^(keep|pending)/.test(each))).toEqual(expected);
});
