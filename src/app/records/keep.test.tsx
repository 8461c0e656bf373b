import { useNotices } from "../base/notices.ts";
import { beforeEach, expect, test, vi } from "vitest";
import type { Job } from "../../program/job/job.ts";
import { takePlace } from "../document/setup-edits.ts";
import { openFirstWork, useEditor } from "../document/store.ts";
import { device, emptyDevice, someJob as job } from "./fake-device.ts";
import { noteShown } from "./opening.ts";
import { usePlace, workElsewhere } from "../place/place.ts";
import { openWork, refreshWorks, startAutosave, startWork, unsavedWorks, useSavedWorks } from "./keep.ts";
import { resume } from "../../shell/resume.ts";

vi.mock("./device.ts", () => import("./fake-device.ts"));

const settle = () => new Promise((done) => setTimeout(done, 0));

beforeEach(() => {
  emptyDevice();
  openFirstWork(null, null);
  useSavedWorks.setState({ works: [], damaged: 0, ready: false });
  useNotices.setState({ notices: [] });
});

test("an empty device opens the start page", async () => {
  await resume();
  expect(useEditor.getState().job).toBeNull();
  expect(useSavedWorks.getState().ready).toBe(true);
  expect(useNotices.getState().notices).toEqual([]);
});

test("every change is saved under the name of the work", async () => {
  const stop = startAutosave();
  void startWork(job);
  takePlace("tool", "7");
  stop();
  await settle();
  const { work } = useEditor.getState();
  expect(device.works.get(work ?? "")?.job).toMatchObject({ tool: 7 });
  expect(sessionStorage.getItem("turnwise/work")).toBe(work);
});

test("a new program leaves the previous one on the device", async () => {
  const stop = startAutosave();
  void startWork(job);
  await settle();
  void startWork({ ...job, name: "SECOND" });
  stop();
  await settle();
  expect([...device.works.values()].map((file) => (file.job as Job).name).sort()).toEqual([job.name, "SECOND"].sort());
});

test("the list shows works that are closed before they are written", async () => {
  const stop = startAutosave();
  void startWork({ ...job, name: "FIRST" });
  void startWork({ ...job, name: "SECOND" });
  openFirstWork(null, null);
  await refreshWorks();
  stop();
  expect(
    useSavedWorks
      .getState()
      .works.map(({ name }) => name)
      .sort(),
  ).toEqual(["FIRST", "SECOND"]);
});

test("a new tab continues the newest work", async () => {
  device.works.set("old", { savedAt: 1, job });
  device.works.set("new", { savedAt: 2, job: { ...job, name: "NEWEST" } });
  await resume();
  expect(useEditor.getState()).toMatchObject({ work: "new", job: { name: "NEWEST" } });
});

test("a reload returns to the work of this tab, or to its start page", async () => {
  device.works.set("mine", { savedAt: 1, job });
  device.works.set("other", { savedAt: 2, job });
  sessionStorage.setItem("turnwise/work", "mine");
  await resume();
  expect(useEditor.getState().work).toBe("mine");
  sessionStorage.setItem("turnwise/work", "");
  await resume();
  expect(useEditor.getState().job).toBeNull();
});

/** What a page leaves on the device when it ends without a word. */
const journal = (work: string | null) => localStorage.getItem(`turnwise/journal/${work}`);
const leaves = (work: string | null, text: string | null) =>
  localStorage.setItem(`turnwise/journal/${work}`, text ?? "");

test("each change is on the device at once, and the next page has it, unless a newer state was saved", async () => {
  const stop = startAutosave();
  void startWork(job);
  await settle();
  takePlace("tool", "8");
  const { work } = useEditor.getState();
  const left = journal(work);
  stop();
  await settle();
  expect(journal(work)).toBeNull();
  device.works.clear();
  leaves(work, left);
  await resume();
  expect(useEditor.getState()).toMatchObject({ work, job: { tool: 8 } });
  expect(journal(work)).toBeNull();
  device.works.set(work ?? "", { savedAt: 9e12, job: { ...job, tool: 9 } });
  leaves(work, left);
  await resume();
  expect(useEditor.getState()).toMatchObject({ work, job: { tool: 9 } });
});

test("a change during writing is on the device, whether or not the state before it was written", async () => {
  let done: () => void = () => undefined;
  device.slow = new Promise((resolve) => (done = resolve));
  const stop = startAutosave();
  void startWork(job);
  document.dispatchEvent(new Event("visibilitychange"));
  takePlace("tool", "8");
  const { work } = useEditor.getState();
  const left = journal(work);
  done();
  await settle();
  stop();
  await settle();
  const [, { from = null } = {}] = (JSON.parse(left ?? "") as { links: { from: number | null }[] }).links;
  for (const savedAt of [null, from]) {
    openFirstWork(null, null);
    device.works.clear();
    if (savedAt !== null) device.works.set(work ?? "", { savedAt, job });
    leaves(work, left);
    await resume();
    expect(useEditor.getState()).toMatchObject({ job: { tool: 8 } });
  }
});

test("a work that was open when the page died is offered, and opens on request", async () => {
  device.works.set("poison", { savedAt: 1, job });
  localStorage.setItem("turnwise/opening/poison", "1");
  sessionStorage.setItem("turnwise/work", "poison");
  await resume();
  expect([useEditor.getState().job, workElsewhere(usePlace.getState())]).toEqual([
    null,
    { work: "poison", name: job.name, cause: "died" },
  ]);
  await openWork("poison");
  expect(useEditor.getState().work).toBe("poison");
  noteShown();
  await resume();
  expect(useEditor.getState().work).toBe("poison");
});

test("a device without storage, and damaged saves, give a notice and stop nothing", async () => {
  Object.assign(device, { refuses: "refused", setAside: 2 });
  await resume();
  expect(useSavedWorks.getState()).toMatchObject({ ready: true, damaged: 2 });
  expect(useNotices.getState().notices).toEqual(["notKept"]);
});

test("a refused state gives a notice, stays in memory, and is saved as soon as there is space", async () => {
  device.refuses = "full";
  const stop = startAutosave();
  void startWork(job);
  takePlace("tool", "9");
  stop();
  await settle();
  expect(useNotices.getState().notices).toEqual(["storageFull"]);
  expect(unsavedWorks()).toMatchObject([{ tool: 9 }]);
  const leaving = new Event("beforeunload", { cancelable: true });
  const again = startAutosave();
  dispatchEvent(leaving);
  again();
  expect(leaving.defaultPrevented).toBe(true);
  expect(useEditor.getState().job).toMatchObject({ tool: 9 });
  device.refuses = null;
  await refreshWorks();
  expect(device.works.get(useEditor.getState().work ?? "")?.job).toMatchObject({ tool: 9 });
  expect(unsavedWorks()).toEqual([]);
  expect(useNotices.getState().notices).toEqual([]);
});

test("saves of a newer edition give a notice", async () => {
  device.newer = 2;
  await resume();
  expect(useNotices.getState().notices).toEqual(["newerWorks"]);
});

test("a state restored by undo before its successor is written is the one saved", async () => {
  const stop = startAutosave();
  void startWork(job);
  const rested = () => new Promise((done) => setTimeout(done, 120));
  await rested();
  const first = useEditor.getState();
  takePlace("tool", "7");
  useEditor.setState(first);
  await rested();
  expect([...device.works.values()].map(({ job: kept }) => kept)).toEqual([first.job]);

  let write = () => undefined as void;
  device.slow = new Promise((done) => (write = () => done()));
  takePlace("tool", "8");
  await rested();
  useEditor.setState(first);
  write();
  await rested();
  expect([...device.works.values()].map(({ job: kept }) => kept)).toEqual([first.job]);
  stop();
});
