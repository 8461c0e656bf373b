import { useNotices } from "../base/notices.ts";
import { beforeEach, expect, test, vi } from "vitest";
import { documentInView } from "../document/history.ts";
import { takePlace } from "../document/setup-edits.ts";
import { redo, undo } from "../document/steps.ts";
import { openFirstWork, open, useEditor } from "../document/store.ts";
import { workElsewhere, usePlace } from "../place/place.ts";
import { device, emptyDevice, someJob as job } from "./fake-device.ts";
import {
  copyWork,
  openWork,
  refreshWorks,
  startAutosave,
  startWork,
  takeOver,
  unsavedWorks,
  useSavedWorks,
} from "./keep.ts";
import { resume } from "../../shell/resume.ts";
import { owns } from "./tab.ts";
import { duplicateWork, freeName, removeWorks, renameWork } from "./works.ts";

vi.mock("./device.ts", () => import("./fake-device.ts"));

const settle = () => new Promise((done) => setTimeout(done, 0));
/** Another tab, as this one hears it. */
const other = new BroadcastChannel("turnwise");
const answers: unknown[] = [];
other.addEventListener("message", ({ data }: MessageEvent<unknown>) => void answers.push(data));
/** Waits for what other tabs, the delay of saving and parts of the page bring about; on a busy machine that takes long. */
const eventually = (check: () => void) => vi.waitFor(check, { timeout: 60_000, interval: 10 });

beforeEach(() => {
  emptyDevice();
  openFirstWork(null, null);
  answers.length = 0;
  other.onmessage = null;
  useSavedWorks.setState({ works: [], damaged: 0, ready: false });
  useNotices.setState({ notices: [] });
});

test("a work open in another tab is not opened, with a message; copying it leaves it unchanged", async () => {
  device.works.set("shared", { savedAt: 1, job });
  device.taken.add("turnwise shared");
  await resume();
  expect(useEditor.getState()).toMatchObject({ work: null, job: null });
  expect(workElsewhere(usePlace.getState())).toEqual({ work: "shared", name: job.name, cause: "isOpen" });
  const stop = startAutosave();
  await copyWork("shared", (name) => `${name}_2`);
  expect(workElsewhere(usePlace.getState())).toBeNull();
  takePlace("tool", "9");
  stop();
  await settle();
  const { work } = useEditor.getState();
  expect(work).not.toBe("shared");
  expect(device.works.get("shared")?.job).toEqual(job);
  expect(device.works.get(work ?? "")?.job).toMatchObject({ tool: 9, name: `${job.name}_2` });
});

test("a work is taken over with the newest state of the other tab, which the device may not have", async () => {
  device.works.set("asked", { savedAt: 1, job });
  device.taken.add("turnwise asked");
  await resume();
  other.onmessage = ({ data }: MessageEvent<{ kind: string; to: string }>) => {
    if (data.kind !== "give") return;
    device.taken.clear();
    other.postMessage({ kind: "given", work: "asked", to: data.to, state: { ...job, rapid: "4321" } });
  };
  const stop = startAutosave();
  expect(await takeOver("asked")).toBe(true);
  expect(useEditor.getState()).toMatchObject({ work: "asked", job: { rapid: "4321" } });
  stop();
  await settle();
  expect(device.works.get("asked")?.job).toMatchObject({ rapid: "4321" });
});

test("a tab that does not answer loses the work in its saved state", async () => {
  vi.useFakeTimers();
  device.works.set("silent", { savedAt: 1, job: { ...job, rapid: "77" } });
  device.taken.add("turnwise silent");
  const taking = takeOver("silent");
  await vi.runAllTimersAsync();
  expect(await taking).toBe(true);
  vi.useRealTimers();
  expect(useEditor.getState()).toMatchObject({ work: "silent", job: { rapid: "77" } });
});

test("a work requested by another tab goes there with the last key, and is closed here", async () => {
  const stop = startAutosave();
  void startWork(job);
  const { work } = useEditor.getState();
  await eventually(() => expect(device.works.has(work ?? "")).toBe(true));
  takePlace("tool", "6");
  other.postMessage({ kind: "give", work, to: "me" });
  await eventually(() => expect(answers).toContainEqual({ kind: "given", work, to: "me", state: null }));
  expect(device.works.get(work ?? "")?.job).toMatchObject({ tool: 6 });
  expect(useEditor.getState().work).toBeNull();
  expect(workElsewhere(usePlace.getState())).toMatchObject({ work, cause: "wasTaken" });
  expect(documentInView()).toBeNull();
  stop();
});

test("a state that the device refused goes to the other tab in the answer", async () => {
  device.refuses = "full";
  const stop = startAutosave();
  void startWork(job);
  const { work } = useEditor.getState();
  takePlace("tool", "4");
  other.postMessage({ kind: "give", work, to: "me" });
  const given = { kind: "given", work, to: "me", state: expect.objectContaining({ tool: 4 }) };
  await eventually(() => expect(answers).toContainEqual(given));
  expect(unsavedWorks()).toEqual([]);
  device.refuses = null;
  stop();
});

test("a work that was released while it opened is claimed again in its present state", async () => {
  const stop = startAutosave();
  void startWork(job);
  const { work } = useEditor.getState();
  const written = () => eventually(() => expect(device.works.has(work ?? "")).toBe(true));
  const released = () => eventually(() => expect(owns(work ?? "")).toBe(false));
  await written();
  open(null, null);
  await released();
  device.works.set(work ?? "", { savedAt: 9, job: { ...job, rapid: "5432" } });
  open(job, work);
  await eventually(() => expect(useEditor.getState()).toMatchObject({ work, job: { rapid: "5432" } }));
  device.taken.add(`turnwise ${work}`);
  open(null, null);
  await released();
  open(job, work);
  await eventually(() => expect(workElsewhere(usePlace.getState())).toMatchObject({ work, cause: "isOpen" }));
  expect(device.works.get(work ?? "")?.job).toMatchObject({ rapid: "5432" });
  stop();
});

test("works are deleted only on request, and undo restores them unchanged", async () => {
  for (let i = 0; i < 150; i += 1) device.works.set(`w${i}`, { savedAt: i, job: { ...job, name: `N${i}` } });
  device.taken.add("turnwise w9");
  await refreshWorks();
  expect(useSavedWorks.getState().works.length).toBe(150);
  expect(await removeWorks(["w3", "w9", "w41", "none"])).toMatchObject({
    gone: [{ work: "w3" }, { work: "w41" }],
    leftOut: 1,
  });
  expect(useSavedWorks.getState().works.map(({ work }) => work)).not.toContain("w41");
  expect(useSavedWorks.getState().works.length).toBe(148);
  undo("works");
  await eventually(() => expect(useSavedWorks.getState().works.length).toBe(150));
  expect(device.works.get("w41")).toEqual({ savedAt: 41, job: { ...job, name: "N41" } });
  redo("works");
  await eventually(() => expect(useSavedWorks.getState().works.length).toBe(148));
  await openWork("w0");
  expect(useEditor.getState().job).toMatchObject({ name: "N0" });
});

test("many works are deleted and restored one after the other", async () => {
  for (let i = 0; i < 40; i += 1) device.works.set(`w${i}`, { savedAt: i, job: { ...job, name: `N${i}` } });
  const { gone } = await removeWorks([...device.works.keys()]);
  expect([gone.length, device.works.size, device.atOnce]).toEqual([40, 0, 1]);
  undo("works");
  await eventually(() => expect(device.works.size).toBe(40));
  expect(device.atOnce).toBe(1);
});

test("a work that the device does not delete stays, with what is not saved of it", async () => {
  const stop = startAutosave();
  void startWork(job);
  const { work } = useEditor.getState();
  await eventually(() => expect(device.works.has(work ?? "")).toBe(true));
  device.refuses = "refused";
  takePlace("tool", "4");
  expect(await removeWorks([work ?? "", "none"])).toEqual({ gone: [], leftOut: 0, refused: 1 });
  await eventually(() => expect(unsavedWorks()).toMatchObject([{ tool: 4 }]));
  device.refuses = null;
  expect(await removeWorks([work ?? ""])).toMatchObject({ gone: [{ job: { tool: 4 } }], refused: 0 });
  expect([device.works.size, unsavedWorks()]).toEqual([0, []]);
  stop();
});

test("a work is renamed in place, and duplicated under a free name", async () => {
  const file = (name: string) => ({ name, text: "M30", encoding: "utf-8" as const });
  device.works.set("a", { savedAt: 7, job: { ...file("A.h"), files: [file("SUB.H")] } });
  expect(await renameWork("a", "sub.h")).toBe("nameTaken");
  expect(await renameWork("a", "B.h")).toBe("done");
  expect(device.works.get("a")).toMatchObject({ savedAt: 7, job: { name: "B.h" } });
  undo("works");
  await eventually(() => expect(device.works.get("a")).toMatchObject({ savedAt: 7, job: { name: "A.h" } }));
  const made = await duplicateWork("a", ["A.h", "a_2.H"]);
  expect(device.works.get(made?.work ?? "")?.job).toMatchObject({ name: "A_3.h", files: [{ name: "SUB.H" }] });
  undo("works");
  await eventually(() => expect([...device.works.keys()]).toEqual(["a"]));
  device.taken.add("turnwise a");
  expect(await renameWork("a", "C.h")).toBe("elsewhere");
  device.refuses = "full";
  device.taken.clear();
  expect(await renameWork("a", "C.h")).toBe("failed");
  expect(await duplicateWork("a", [])).toBeNull();
});

test.each([
  ["SHAFT", [], "SHAFT_2"],
  ["SHAFT_2", ["SHAFT", "shaft_2"], "SHAFT_3"],
  ["A.H", ["a_2"], "A_3.H"],
  ["X".repeat(40), [], `${"X".repeat(30)}_2`],
])("beside %s among %j comes %s", (name, taken, made) => expect(freeName(name, taken)).toBe(made));
