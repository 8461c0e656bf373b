import { beforeEach, expect, test, vi } from "vitest";
import { NO_PROGRESS, progressOfTask, withHint, withPass, withPlace } from "../../course/progress.ts";
import { newParameter, type OwnEntry } from "../../program/edits/own-cycle.ts";
import { usualTable, writeCuttingTable } from "../../program/tools/cutting-table.ts";
import { shippedList } from "../../program/tools/tool-list.ts";
import { useLearning } from "../../app/records/course/progress.ts";
import { ownRecord, useOwn } from "../../app/document/own-store.ts";
import { answerOf } from "../../course/judge/answer.ts";
import { proposedTask } from "../../course/made/task-from-form.ts";
import { RESULT_FORMAT } from "../../course/made/result.ts";
import { useCollectedResults } from "../../app/records/course/collected-results.ts";
import { useForms } from "../../app/records/course/kept-form.ts";
import { workedRecord } from "../../app/records/course/working-time.ts";
import type { ReadArchive } from "../../app/records/archive.ts";
import { device, emptyDevice, someJob as job } from "../../app/records/fake-device.ts";
import { refreshWorks } from "../../app/records/keep.ts";
import { changeSettings, firstSettings, useSettings } from "../../app/base/settings/settings.ts";
import { forgetAllSteps, undo } from "../../app/document/steps.ts";
import { toolRecord, useTools } from "../../app/document/tool-store.ts";
import { boxOffer, DEFAULT_CHOICES, statesOf, tableOffer, restoreArchive } from "./restore-archive.ts";

vi.mock("../../app/records/device.ts", () => import("../../app/records/fake-device.ts"));

const own = (id: string, number: string, name: string): OwnEntry => ({
  id,
  number,
  name,
  parameters: [newParameter("p1", { q: "Q1711", prompt: "LENGTH", kind: "length" })],
});
const row = (id: string, T: string, NAME: string) => ({ id, cells: { ...shippedList[0]?.cells, T, NAME } });
const settings = { ...firstSettings(), xDown: true };
const archive: ReadArchive = {
  works: [
    { work: "same", savedAt: 41, job },
    { work: "mine", savedAt: 42, job: { ...job, rapid: "4321" } },
    {
      work: "",
      savedAt: 43,
      job: { ...job, name: "NEW" },
    },
    { work: "free", savedAt: 44, job: { ...job, name: "FREE" } },
  ],
  tools: [row("r1", "1", "OTHER 1"), row("x", "88.1", "GROOVER")],
  parts: null,
  own: [own("c1", "1711", "OTHERS"), own("c2", "1713", "SAW")],
  settings,
  course: withPlace(withPass(NO_PROGRESS, "l03-thicker-bar", { when: 7, seconds: 41.7 }), {
    lesson: "tool",
    number: 2,
    page: 3,
  }),
  taught: null,
  sets: null,
  exams: null,
  forms: null,
  worked: null,
  results: null,
  columns: null,
  unread: [],
  unreadParts: [],
  unreadRows: [],
};
const NOTHING = { ...DEFAULT_CHOICES, course: "keep" } as const;
const COURSE = DEFAULT_CHOICES;
const rested = () => new Promise((done) => setTimeout(done, 30));
const named = () => [...device.works].map(([work, { job: kept }]) => [work, (kept as typeof job).name]);

beforeEach(async () => {
  emptyDevice();
  toolRecord.replace([row("r1", "1", "MINE 1"), row("r2", "2", "MINE 2")]);
  ownRecord.replace([own("c1", "1711", "MINE")]);
  changeSettings(firstSettings());
  forgetAllSteps();
  device.works.set("mine", { savedAt: 1, job });
  await refreshWorks();
});

test("works are compared by content, not by name", async () => {
  expect(await statesOf(archive.works)).toEqual(["same", "beside", "fresh", "fresh"]);
});

test("restored works are added to those of the device, with their time of change, and undo removes them", async () => {
  const works = archive.works.slice(1);
  expect(await restoreArchive(archive, works, NOTHING)).toEqual({ kept: 3, full: 0, undone: false });
  expect(device.works.get("mine")).toEqual({ savedAt: 1, job });
  expect(device.works.get("free")).toEqual({ savedAt: 44, job: { ...job, name: "FREE" } });
  expect(named().map(([, name]) => name)).toEqual([job.name, job.name, "NEW", "FREE"]);
  expect(named().some(([work]) => work === "")).toBe(false);
  expect([useTools.getState().list.length, useSettings.getState().xDown]).toEqual([2, false]);
  undo("works");
  await rested();
  expect(named()).toEqual([["mine", job.name]]);
});

test("the missing rows of tables are restored, or all of them, each as one step", async () => {
  const names = () => useTools.getState().list.map(({ cells }) => cells.NAME);
  const cycles = () => useOwn.getState().list.map(({ name }) => name);
  await restoreArchive(archive, [], { ...NOTHING, tools: "missing", own: "missing", settings: "missing" });
  expect(names()).toEqual(["MINE 1", "MINE 2", "GROOVER"]);
  expect(cycles()).toEqual(["MINE", "SAW"]);
  expect(useSettings.getState().xDown).toBe(true);
  undo("own-cycles");
  expect([names().length, cycles().length]).toEqual([3, 1]);
  undo("tools");
  expect(names()).toEqual(["MINE 1", "MINE 2"]);
  await restoreArchive(archive, [], { ...NOTHING, tools: "replace", own: "replace" });
  expect([names(), cycles()]).toEqual([
    ["OTHER 1", "GROOVER"],
    ["OTHERS", "SAW"],
  ]);
});

test("a machine is restored with the settings; without one in the backup, that of the device stays", async () => {
  const take = (machine: string) =>
    restoreArchive({ ...archive, settings: { ...settings, machine } }, [], { ...NOTHING, settings: "missing" });
  changeSettings({ machine: "mine" });
  await take("");
  expect(useSettings.getState().machine).toBe("mine");
  await take("theirs");
  expect(useSettings.getState().machine).toBe("theirs");
});

test("cutting data are restored with the settings; without them in the backup, the shop's own stay", async () => {
  const mine = writeCuttingTable({ ...usualTable, power: 7.3 }),
    theirs = writeCuttingTable({ ...usualTable, power: 18.9 });
  const take = (cutting: string, wanted: boolean) =>
    restoreArchive({ ...archive, settings: { ...settings, material: "brass", cutting } }, [], {
      ...NOTHING,
      settings: wanted ? "missing" : "keep",
    });
  const here = () => [useSettings.getState().material, useSettings.getState().cutting];
  changeSettings({ material: "16mncr5", cutting: mine });
  await take(theirs, false);
  expect(here()).toEqual(["16mncr5", mine]);
  await take("", true);
  expect(here()).toEqual(["brass", mine]);
  await take(theirs, true);
  expect(here()).toEqual(["brass", theirs]);
});

test("identical tables have nothing missing to restore", () => {
  const [tools, own] = [toolRecord.now(), ownRecord.now()];
  expect(tableOffer({ ...archive, tools: tools.map((each) => ({ ...each, id: `${each.id}x` })) }, "tools")).toEqual({
    rows: 2,
    missing: null,
  });
  expect(tableOffer(archive, "tools")).toEqual({ rows: 2, missing: 1 });
  expect(tableOffer({ ...archive, own }, "own")).toEqual({ rows: 1, missing: null });
  expect([tableOffer({ ...archive, own: [] }, "own"), tableOffer({ ...archive, tools: null }, "tools")]).toEqual([
    null,
    null,
  ]);
  expect(tableOffer({ ...archive, tools: [] }, "tools")).toEqual({ rows: 0, missing: 0 });
});

test("works without room are counted, and nothing else is changed", async () => {
  device.refuses = "full";
  expect(await restoreArchive(archive, archive.works.slice(2), NOTHING)).toEqual({ kept: 0, full: 2, undone: false });
  expect(named()).toEqual([["mine", job.name]]);
});

test("course progress of the backup is merged with the progress here, and undo removes it", async () => {
  const hinted = withPass(withHint(NO_PROGRESS, "l03-thicker-bar", 1), "l03-thicker-bar", { when: 3, seconds: 37.2 });
  const mine = withPass(hinted, "l01-sawn-long", { when: 4 });
  useLearning.setState({ list: mine });
  expect([
    boxOffer(archive, "course"),
    boxOffer({ ...archive, course: mine }, "course"),
    boxOffer({ ...archive, course: null }, "course"),
  ]).toEqual([true, false, null]);
  expect((await restoreArchive(archive, [], COURSE)).undone).toBe(true);
  const { list } = useLearning.getState();
  expect(progressOfTask(list, "l03-thicker-bar")).toMatchObject({
    passed: { way: "alone", when: 7 },
    seconds: 37.2,
    hints: 1,
  });
  expect([progressOfTask(list, "l01-sawn-long").passed?.when, list.last?.page]).toEqual([4, 3]);
  undo("course");
  expect(useLearning.getState().list).toBe(mine);
});

test("forms, working times and results of learners are merged with those here, as one step; a form follows its work", async () => {
  const form = {
    form: { ...proposedTask(answerOf("0 BEGIN PGM A MM\n1 END PGM A MM\n")), clean: true },
    print: "7 x",
    at: 1_795_395_781_123,
  };
  const mine = { ...form, print: "8 y" };
  const ada = {
    file: "a.json",
    result: { format: RESULT_FORMAT as typeof RESULT_FORMAT, name: "Ada", made: 1_795_395_781_123, tasks: [] },
  };
  const zoe = { file: "z.json", result: { ...ada.result, name: "Zoé" } };
  useForms.setState({ list: { "task bush": mine } });
  workedRecord.put({ bush: { ms: 7_319, steps: 11 } });
  useCollectedResults.setState({ list: [ada] });
  // The key "mine" is taken: the restored work gets another one.
  const brought = {
    ...archive,
    course: null,
    forms: { "work mine": form, "task bush": form },
    worked: { bush: { ms: 3_001, steps: 17 }, disc: { ms: 5, steps: 1 } },
    results: [zoe, ada],
  };
  expect([
    boxOffer(brought, "course"),
    boxOffer({ ...brought, forms: null, worked: null, results: [ada] }, "course"),
  ]).toEqual([true, false]);
  const works = [{ work: "mine", savedAt: 3, job: { ...job, name: "OTHER" } }];
  await restoreArchive(brought, works, COURSE);
  const other = [...device.works].find(([, { job: kept }]) => (kept as typeof job).name === "OTHER")?.[0] ?? "";
  expect(useForms.getState().list).toEqual({ [`work ${other}`]: form, "task bush": mine });
  expect(workedRecord.now()).toEqual({ bush: { ms: 7_319, steps: 17 }, disc: { ms: 5, steps: 1 } });
  expect(useCollectedResults.getState().list).toEqual([ada, zoe]);
  undo("course");
  expect([workedRecord.now(), useCollectedResults.getState().list]).toEqual([
    { bush: { ms: 7_319, steps: 11 } },
    [ada],
  ]);
  expect(Object.keys(useForms.getState().list)).toEqual(["task bush"]);
});
