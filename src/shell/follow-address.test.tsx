import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { cuttingCycles } from "../cycles/index.ts";
import { exampleJob } from "../program/job/job.ts";
import {
  openPrompt,
  openToolRow,
  shownPage,
  showOwn,
  showSection,
  showTools,
  showWhich,
  uncover,
  usePlace,
} from "../app/place/place.ts";
import { useNotices, withdraw } from "../app/base/notices.ts";
import { startAutosave, startWork } from "../app/records/keep.ts";
import { openFirstWork, useEditor } from "../app/document/store.ts";
import { followAddress } from "./follow-address.ts";
import { goHome } from "../app/document/go-home.ts";

const [cycle] = cuttingCycles;
if (!cycle) throw new Error("the catalogue is empty");
const job = exampleJob(cycle);
const place = usePlace.getState();
let stops: (() => void)[] = [];

beforeEach(() => {
  openFirstWork(null, null);
  usePlace.setState(place);
  withdraw("workNotHere");
  history.pushState(null, "", "/");
  stops = [startAutosave(), followAddress()];
});
afterEach(() => stops.forEach((stop) => stop()));

/** Waits for a condition, also on a slow machine. */
const until = (holds: () => void) => vi.waitFor(holds, { timeout: 20_000 });
const settled = () => new Promise((done) => setTimeout(done));
const is = (hash: string) => until(() => expect(location.hash).toBe(hash));
/** Starts a work; returns its key. */
async function started(): Promise<string> {
  void startWork(job);
  await settled();
  return useEditor.getState().work ?? "";
}

test("Back closes a dialog first, and so does a typed address", async () => {
  const work = await started();
  showSection("setup");
  await is(`#/work/${work}/setup`);
  const dialog = document.body.appendChild(document.createElement("dialog"));
  dialog.close = () => dialog.removeAttribute("open");
  dialog.open = true;
  history.back();
  await until(() => expect(dialog.open).toBe(false));
  await is(`#/work/${work}/setup`);
  expect(usePlace.getState().section).toBe("setup");
  dialog.open = true;
  location.hash = "#/tools/5";
  await until(() => expect(shownPage(usePlace.getState()).page).toBe("tools"));
  expect(dialog.open).toBe(false);
  dialog.remove();
  history.back();
  await is(`#/work/${work}/setup`);
  history.back();
  await until(() => expect(usePlace.getState().section).toBe("prompts"));
});

test("Back goes through tools, set-up and work to the start page, and Forward the same way", async () => {
  const work = await started();
  showSection("setup");
  await is(`#/work/${work}/setup`);
  showTools("r5");
  await is("#/tools/5");
  history.back();
  await until(() => expect(shownPage(usePlace.getState()).page).toBe("work"));
  await is(`#/work/${work}/setup`);
  history.back();
  await until(() => expect(usePlace.getState().section).toBe("prompts"));
  history.back();
  await until(() => expect(useEditor.getState().work).toBeNull());
  await is("#/");
  history.forward();
  await until(() => expect(useEditor.getState().work).toBe(work));
  history.forward();
  await until(() => expect(usePlace.getState().section).toBe("setup"));
  history.forward();
  await until(() => expect([location.hash, usePlace.getState().tools.row]).toEqual(["#/tools/5", "r5"]));
});

test("changes in one task are one entry, and no change is none", async () => {
  const before = history.length;
  showTools("r3");
  uncover();
  void startWork(job);
  openPrompt("Q494", "-3.25");
  await settled();
  expect(history.length).toBe(before + 1);
  showSection("prompts");
  openPrompt("Q491", "41.3");
  await settled();
  expect(history.length).toBe(before + 1);
});

test("selecting rows of a table adds no entries, and closing it goes back", async () => {
  const work = await started();
  const before = history.length;
  showTools();
  await is("#/tools");
  openToolRow("r2");
  await is("#/tools/2");
  openToolRow("r7");
  await is("#/tools/7");
  uncover();
  await is(`#/work/${work}`);
  expect(history.length).toBe(before + 1);
  history.forward();
  await is("#/tools/7");
});

test("the dialog that finds a cycle has an entry, and the own cycles too", async () => {
  showWhich();
  await is("#/which");
  history.back();
  await until(() => expect(usePlace.getState().over).toBeNull());
  showOwn();
  await is("#/own");
  uncover();
  await is("#/");
});

test("a deleted work leads to the start page, which says so", async () => {
  location.hash = "#/work/gone/setup";
  await until(() => expect(useNotices.getState().notices).toContain("workNotHere"));
  await is("#/");
  expect(useEditor.getState().work).toBeNull();
});

test("an invalid address is replaced by the present one", async () => {
  const work = await started();
  location.hash = "#/kitchen";
  await is(`#/work/${work}`);
  expect(useEditor.getState().work).toBe(work);
});

test("Back to a work opens the prompt that was open there", async () => {
  const work = await started();
  openPrompt("Q494", "-3.25");
  await until(() => expect(history.state).toMatchObject({ prompt: "Q494" }));
  goHome();
  await is("#/");
  history.back();
  await is(`#/work/${work}`);
  await until(() => expect(usePlace.getState()).toMatchObject({ prompt: "Q494", before: "-3.25" }));
});

test("a prompt left at once for a page over the work is open again, however far one goes back and forward", async () => {
  const work = await started(),
    third = Object.keys(cycle.params)[2] ?? "";
  openPrompt(third, "7.9");
  showTools();
  await is("#/tools");
  history.go(-2);
  await is("#/");
  await until(() => expect(useEditor.getState().work).toBe(null));
  history.forward();
  await is(`#/work/${work}`);
  await until(() => expect(usePlace.getState().prompt).toBe(third));
});
