import * as fc from "fast-check";
import { afterAll, afterEach, beforeAll, beforeEach, expect, test } from "vitest";
import { addTool, duplicateTool, removeTool, setCell } from "../../features/tools/tool-edits.ts";
import { cuttingCycles } from "../../cycles/index.ts";
import { exampleJob } from "../../program/job/job.ts";
import { shippedList } from "../../program/tools/tool-list.ts";
import { setContour, setPrompt } from "../document/edits.ts";
import { setPlace } from "../document/setup-edits.ts";
import { redoStep, undoStep } from "../document/history.ts";
import { asOneStep, closeStep, forgetAllSteps, historyOf } from "../document/steps.ts";
import {
  changeProgram,
  flushEdits,
  open,
  openContent,
  openFirstWork,
  pendingEdits,
  useEditor,
} from "../document/store.ts";
import { toolRecord, useTools } from "../document/tool-store.ts";
import { isProgram, type Work } from "../document/work.ts";
import { closeSession, dispatchEdit, flushText, openSession, sessionText } from "../fields/blocks/session.ts";
import { startKeepingSteps } from "./keep-steps.ts";

const [cycle] = cuttingCycles;
if (!cycle) throw new Error("the catalogue is empty");
const prompts = Object.keys(cycle.params);
const FIRST: Readonly<Record<string, Work>> = {
  cycle: exampleJob(cycle),
  program: {
    name: "A.h",
    text: "0 BEGIN PGM A MM\n1 L X+41.3 Z-3.25 FMAX\n2 M30\n3 END PGM A MM\n",
    encoding: "utf-8",
  },
};
const WORKS = ["cycle", "program"] as const;

/** The works on the device; the open one is saved when it is left. */
const device = new Map<string, string>();
function show(work: string): void {
  flushEdits();
  const before = useEditor.getState();
  if (before.work !== null) device.set(before.work, JSON.stringify(openContent()));
  if (before.work === work) return;
  closeSession();
  const content = JSON.parse(device.get(work) ?? "null") as Work;
  open(content, work);
  if (isProgram(content)) openSession(content, work);
}
/** Everything there is, as it is stored. */
const documents = () => {
  flushEdits();
  const { work } = useEditor.getState();
  const works = WORKS.map((each) => [`work ${each}`, each === work ? JSON.stringify(openContent()) : device.get(each)]);
  return Object.fromEntries([...works, ["tools", JSON.stringify(useTools.getState().list)]]) as Record<string, string>;
};
/** The page is reloaded: nothing in memory. */
function reload(): void {
  const work = useEditor.getState().work ?? "";
  show(work);
  dispatchEvent(new Event("pagehide"));
  closeSession();
  forgetAllSteps();
  openFirstWork(null, null);
  show(work);
}

const small = fc.nat(9);
const change = fc.oneof(
  fc.record({ do: fc.constant("show" as const), at: small, to: small }),
  fc.record({
    do: fc.constantFrom("type", "erase", "switch", "prompt", "contour", "tool", "both"),
    at: small,
    to: small,
  }),
  fc.record({ do: fc.constantFrom("cell", "add", "copy", "remove"), at: small, to: small }),
  fc.record({ do: fc.constantFrom("undo", "redo", "leave"), at: small, to: small }),
);

function run({ do: what, at, to }: { readonly do: string; readonly at: number; readonly to: number }): void {
  const rows = useTools.getState().list;
  const row = rows[at % Math.max(1, rows.length)]?.id ?? "";
  const length = sessionText()?.length ?? 0;
  const offset = Math.round((length * at) / 10);
  const q = prompts[at % prompts.length] ?? "";
  const inJob = useEditor.getState().job !== null;
  if (what === "show") return show(WORKS[at % 2] ?? "cycle");
  if (what === "leave") return closeStep();
  if (what === "cell") return setCell(row, "RS", String(to));
  if (what === "add") return void addTool("turning");
  if (what === "copy") return void duplicateTool(row);
  if (what === "remove") return void removeTool(row);
  if (what === "undo" || what === "redo")
    return (what === "undo" ? undoStep : redoStep)(["work cycle", "work program", "tools"][at % 3]);
  if (inJob) {
    if (what === "prompt") setPrompt(q, String(to));
    if (what === "tool") setPlace("tool", String(to));
    if (what === "contour") setContour((openContent() as ReturnType<typeof exampleJob>).contour.slice(to % 2));
    if (what === "both") asOneStep(() => [setPrompt(q, `${to}.5`), setPlace("tool", String(to + 20))]);
  } else {
    if (what === "type") dispatchEdit({ changes: { from: offset, insert: `X${to}` } }, null);
    if (what === "erase") dispatchEdit({ changes: { from: offset, to: Math.min(length, offset + to) } }, `at ${at}`);
    if (what === "switch") changeProgram((work) => ({ ...work, remarks: String(to) }));
  }
}

/** Takes a whole history back, or restores it. */
function goThrough(document: string, way: "past" | "future"): void {
  for (let steps = historyOf(document)[way].length; steps > 0; steps--)
    (way === "past" ? undoStep : redoStep)(document);
}

let stop = () => undefined as void;
beforeAll(() => void pendingEdits.add(flushText));
afterAll(() => void pendingEdits.delete(flushText));
beforeEach(() => (stop = startKeepingSteps()));
afterEach(() => stop());

test.each([false, true])(
  "undoing all steps of one document restores its beginning and leaves the others alone; reload between: %s",
  (reloads) => {
    fc.assert(
      fc.property(fc.array(change, { minLength: 1, maxLength: 25 }), (changes) => {
        closeSession();
        sessionStorage.clear();
        openFirstWork(null, null);
        toolRecord.replace(shippedList);
        forgetAllSteps();
        for (const work of WORKS) device.set(work, JSON.stringify(FIRST[work]));
        show("cycle");
        const first = documents();
        for (const each of changes) run(each);
        if (reloads) reload();
        for (const document of ["work cycle", "work program", "tools"]) {
          const work = document.split(" ")[1];
          if (work !== undefined) show(work);
          goThrough(document, "future");
          const before = documents();
          goThrough(document, "past");
          expect(documents()).toEqual({ ...before, [document]: first[document] });
          goThrough(document, "future");
          expect(documents()).toEqual(before);
        }
      }),
      { numRuns: 60 },
    );
  },
);
