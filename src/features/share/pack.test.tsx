import { undoStep, redoStep } from "../../app/document/history.ts";
import { afterEach, expect, test, vi } from "vitest";
import { cuttingCycles } from "../../cycles/index.ts";
import { exampleJob, UNSET } from "../../program/job/job.ts";
import { EXAMPLE_MACHINES } from "../../program/machine/example-machines.ts";
import { machineOf, writeMachine } from "../../program/machine/machine-file.ts";
import { shippedList } from "../../program/tools/tool-list.ts";
import { reported } from "../../app/calculation/reported.ts";
import { openText } from "../../app/fields/open/open-program.ts";
import { readArchive } from "../../app/records/archive.ts";
import { changeSettings } from "../../app/base/settings/settings.ts";
import { openFirstWork, bundleOf, useEditor } from "../../app/document/store.ts";
import { editTools, toolRecord, useTools } from "../../app/document/tool-store.ts";
import { controlInUse, machineInUse, toolTable } from "../../app/document/work-tools.ts";
import { isProgram, type Work } from "../../app/document/work.ts";
import { printedText } from "../../app/document/printed.ts";
import { handedWork } from "../../app/records/incoming.ts";
import { linkOf, readLink } from "../../app/records/link.ts";
import { packWork, packedFile } from "./pack.ts";
import {
  renumberCalls,
  countAffectedCalls,
  keepWorkTools,
  switchToDeviceControl,
  switchToDeviceMachine,
  switchToDeviceTable,
} from "./work-tools-edits.ts";

/** A stub of the worker's answer. */
vi.mock("../../app/calculation/other-outcome.ts", () => ({
  reportOf: (work: Work, file: string) =>
    Promise.resolve(
      reported(
        {
          version: 0,
          text: isProgram(work) ? work.text : printedText(work),
          table: toolTable(),
          control: controlInUse(),
          machine: machineOf(machineInUse()),
          rapid: 10_000,
        },
        file,
      ),
    ),
}));

const open = (): Work => {
  const { job, program } = useEditor.getState();
  const work = job ?? program;
  if (!work) throw new Error("no work is open");
  return work;
};
const rs = (number: number) => toolTable().tools.find(({ T }) => T === number)?.RS;
const withRs = (number: number, RS: string) =>
  editTools((list) =>
    list.map((row) => (row.cells.T === String(number) ? { ...row, cells: { ...row.cells, RS } } : row)),
  );
const arrive = (link: string) => {
  const read = readLink(link);
  if (read.kind !== "work") throw new Error("the link holds no work");
  return read.work;
};

afterEach(() => {
  openFirstWork(null, null);
  toolRecord.replace(shippedList);
  changeSettings({ control: "TNC 640", machine: "" });
});

test("a cycle without a chosen tool includes the proposed one, and gives the same report elsewhere", async () => {
  const [cycle] = cuttingCycles;
  if (!cycle) throw new Error("the catalogue is empty");
  openFirstWork({ ...exampleJob(cycle), ...UNSET, drafts: { ...exampleJob(cycle).drafts, 9: { Q1: "7" } } }, "mine");
  changeSettings({ control: "TNC7" });
  const proposed = /TOOL CALL (\d+)/.exec(printedText(open() as never))?.[1] ?? "";
  withRs(Number(proposed), "0.61");
  const sent = await packWork(open());
  expect(sent.work).toMatchObject({ tool: Number(proposed), control: "TNC7" });
  expect(Object.keys((sent.work as { drafts: object }).drafts)).toEqual([String(cycle.number)]);

  toolRecord.replace([]);
  changeSettings({ control: "TNC 640" });
  openFirstWork(arrive(linkOf("", sent.work)), "theirs");
  expect([rs(Number(proposed)), controlInUse()]).toEqual([0.61, "TNC7"]);
  const again = await packWork(open());
  expect(again.report).toBe(sent.report);
  expect(linkOf("", again.work)).toBe(linkOf("", sent.work));
});

test.each([
  ["the data of a machine", writeMachine(EXAMPLE_MACHINES.large), ""],
  ["no machine", "", writeMachine(EXAMPLE_MACHINES.small)],
])(
  "a work that is timed with %s comes to the same times on a device that has other data",
  async (_, machine, other) => {
    const [cycle] = cuttingCycles;
    if (!cycle) throw new Error("the catalogue is empty");
    openFirstWork(exampleJob(cycle), "mine");
    changeSettings({ machine });
    const sent = await packWork(open());
    changeSettings({ machine: other });
    expect((await packWork(open())).report).not.toBe(sent.report);
    openFirstWork(arrive(linkOf("", sent.work)), "theirs");
    expect(machineInUse()).toBe(machine);
    expect((await packWork(open())).report).toBe(sent.report);
    switchToDeviceMachine();
    expect([machineInUse(), bundleOf(useEditor.getState()).control]).toEqual([other, "TNC 640"]);
    undoStep();
    expect(machineInUse()).toBe(machine);
  },
);

test("a task is timed without a machine, as it is judged", () => {
  changeSettings({ machine: writeMachine(EXAMPLE_MACHINES.large) });
  openFirstWork({ ...program, task: { id: "x" } }, "task");
  expect(machineInUse()).toBe("");
});

test("the file contains the same work, and is distinguished from a file of several works", async () => {
  const [cycle] = cuttingCycles;
  if (!cycle) throw new Error("the catalogue is empty");
  openFirstWork(exampleJob(cycle), "mine");
  const sent = await packWork(open());
  const read = readArchive(packedFile(sent));
  expect(handedWork(read)).toEqual(sent.work);
  expect(handedWork({ problem: "damaged" })).toBeNull();
  if (!("works" in read)) throw new Error("the file cannot be read");
  expect(handedWork({ ...read, works: [...read.works, ...read.works] })).toBeNull();
  expect(handedWork({ ...read, own: [] })).toBeNull();
});

const TEXT = "0 BEGIN PGM A MM\r\n1 TOOL CALL 3 ;first\r\n2 TOOL CALL 4\r\n3 CALL PGM B\r\n4 END PGM A MM\r\n";
const program: Work = {
  name: "A.h",
  text: TEXT,
  encoding: "utf-8",
  files: [{ name: "B.h", text: "0 BEGIN PGM B MM\n1 TOOL CALL 3\n2 END PGM B MM\n", encoding: "windows-1252" }],
  tools: shippedList
    .filter(({ cells }) => cells.T === "3" || cells.T === "4")
    .map((row) => ({
      ...row,
      cells: { ...row.cells, RS: "1.3" },
    })),
  control: "TNC7",
};

test("a tool kept at a free number is called there in every file, as one step, and the result is the same with either table", () => {
  openFirstWork(program, "theirs");
  const kept = keepWorkTools(({ number }) => (number === 3 ? "free" : "mine"));
  const to = kept.moved[0]?.to ?? 0;
  expect(kept.moved).toEqual([{ from: 3, to: shippedList.length + 1 }]);
  expect(countAffectedCalls(kept.moved)).toBe(2);
  renumberCalls(kept.moved);
  expect(open()).toMatchObject({
    text: TEXT.replace("TOOL CALL 3", `TOOL CALL ${to}`),
    files: [{ text: `0 BEGIN PGM B MM\n1 TOOL CALL ${to}\n2 END PGM B MM\n` }],
  });
  expect([rs(to), rs(3)]).toEqual([1.3, undefined]);
  switchToDeviceTable();
  expect([bundleOf(useEditor.getState()).tools, controlInUse()]).toEqual([undefined, "TNC7"]);
  expect([rs(to), rs(3)]).toEqual([1.3, 0.4]);
  switchToDeviceControl();
  expect([controlInUse(), Object.keys(bundleOf(useEditor.getState())).includes("control")]).toEqual(["TNC 640", false]);
  undoStep();
  undoStep();
  expect(bundleOf(useEditor.getState()).tools?.map(({ cells }) => cells.T)).toEqual([String(to), "4"]);
  undoStep();
  expect(open()).toEqual(program);
  redoStep();
  expect(countAffectedCalls(kept.moved)).toBe(0);
  undoStep("tools");
  expect(useTools.getState().list).toEqual(shippedList);
});

test("a cycle converted to an NC program keeps its tools and settings", () => {
  const [cycle] = cuttingCycles;
  if (!cycle) throw new Error("the catalogue is empty");
  const tools = shippedList.slice(2, 4);
  openText("0 BEGIN PGM A MM\n", { ...exampleJob(cycle), tools, control: "TNC7" });
  const { output } = exampleJob(cycle);
  expect(open()).toEqual({
    name: "A.h",
    text: "0 BEGIN PGM A MM\n",
    encoding: "utf-8",
    tools,
    control: "TNC7",
    output,
  });
  openText("0 BEGIN PGM B MM\n");
  expect(open()).toEqual({ name: "B.h", text: "0 BEGIN PGM B MM\n", encoding: "utf-8" });
});

test("a cycle takes the new number of its tool", () => {
  const [cycle] = cuttingCycles;
  if (!cycle) throw new Error("the catalogue is empty");
  openFirstWork({ ...exampleJob(cycle), tool: 3, tools: shippedList.filter(({ cells }) => cells.T === "3") }, "theirs");
  expect(countAffectedCalls([{ from: 3, to: 97 }])).toBe(1);
  renumberCalls([{ from: 3, to: 97 }]);
  expect(open()).toMatchObject({ tool: 97, tools: [{ cells: { T: "97" } }] });
  expect(countAffectedCalls([{ from: 3, to: 97 }])).toBe(0);
});
