import { useNotices } from "../base/notices.ts";
import { beforeEach, expect, test, vi } from "vitest";
import type { Job } from "../../program/job/job.ts";
import { takePlace } from "../document/setup-edits.ts";
import { openFirstWork, useEditor } from "../document/store.ts";
import { device, emptyDevice, someJob as job } from "./fake-device.ts";
import { refreshWorks, startAutosave, startWork, unsavedWorks, useSavedWorks } from "./keep.ts";
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
  startWork(job);
  takePlace("tool", "7");
  stop();
  await settle();
  const { work } = useEditor.getState();
  expect(device.works.get(work ?? "")?.job).toMatchObject({ tool: 7 });
  expect(sessionStorage.getItem("turnwise/work")).toBe(work);
});

test("a new program leaves the previous one on the device", async () => {
  const stop = startAutosave();
  startWork(job);
  await settle();
  startWork({ ...job, name: "SECOND" });
  stop();
  await settle();
  expect([...device.works.values()].map((file) => (file.job as Job).name).sort()).toEqual([job.name, "SECOND"].sort());
});

test("the list shows works that are closed before they are written", async () => {
  const stop = startAutosave();
  startWork({ ...job, name: "FIRST" });
  startWork({ ...job, name: "SECOND" });
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

test("a state not written before the page closed is there after a reload, unless a newer one is", async () => {
  const stop = startAutosave();
  startWork(job);
  takePlace("tool", "8");
  dispatchEvent(new Event("pagehide"));
  const { work } = useEditor.getState();
  device.works.clear();
  stop();
  device.works.clear();
  await resume();
  expect(useEditor.getState()).toMatchObject({ work, job: { tool: 8 } });
  sessionStorage.setItem("turnwise/pending", JSON.stringify([{ work, file: { version: 1, savedAt: -1, job } }]));
  await resume();
  expect(useEditor.getState()).toMatchObject({ work, job: { tool: 8 } });
});

test("a page that closes during writing stores that state for the next page, and another work too", async () => {
  let done: () => void = () => undefined;
  device.slow = new Promise((resolve) => (done = resolve));
  const stop = startAutosave();
  startWork({ ...job, name: "FIRST" });
  startWork(job);
  takePlace("tool", "8");
  document.dispatchEvent(new Event("visibilitychange"));
  dispatchEvent(new Event("pagehide"));
  expect(device.works.size).toBe(0);
  const left = sessionStorage.getItem("turnwise/pending") ?? "";
  done();
  stop();
  await settle();
  device.works.clear();
  sessionStorage.setItem("turnwise/pending", left);
  await resume();
  expect(useEditor.getState()).toMatchObject({ job: { tool: 8 } });
  expect([...device.works.values()].map((file) => (file.job as Job).name).sort()).toEqual([job.name, "FIRST"].sort());
  expect(sessionStorage.getItem("turnwise/pending")).toBeNull();
});

test("of a work that the device refused, only the newest state is stored for the next page", async () => {
  device.refuses = "full";
  const stop = startAutosave();
  startWork(job);
  takePlace("tool", "5");
  document.dispatchEvent(new Event("visibilitychange"));
  await settle();
  takePlace("tool", "6");
  dispatchEvent(new Event("pagehide"));
  const { work } = useEditor.getState();
  const left = JSON.parse(sessionStorage.getItem("turnwise/pending") ?? "[]") as {
    work: string;
    file: { job: unknown };
  }[];
  expect(left.filter((behind) => behind.work === work)).toMatchObject([{ file: { job: { tool: 6 } } }]);
  device.refuses = null;
  stop();
  await refreshWorks();
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
  startWork(job);
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
  startWork(job);
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
