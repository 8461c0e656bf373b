import { beforeEach, expect, test } from "vitest";
import { cuttingCycles } from "../../cycles/index.ts";
import { history as de } from "../../i18n/de/history.ts";
import { history as en } from "../../i18n/en/history.ts";
import { history as fr } from "../../i18n/fr/history.ts";
import { history as zh } from "../../i18n/zh/history.ts";
import { parse } from "../../nc/parse.ts";
import { exampleJob } from "../../program/job/job.ts";
import { shippedList } from "../../program/tools/tool-list.ts";
import { firstSettings, changeSettings } from "../base/settings/settings.ts";
import { editSettings } from "./edit-settings.ts";
import {
  setContour,
  setMaterial,
  setName,
  setParameter,
  setPerRevolution,
  setPrompt,
  setPrompts,
  setSpindle,
} from "./edits.ts";
import { setPlace } from "./setup-edits.ts";
import { editOwn, ownRecord } from "./own-store.ts";
import { asOneStep, lastStep, useSteps, type HistoryStep } from "./steps.ts";
import { changeProgram, changeJob, openFirstWork } from "./store.ts";
import { editTools, toolRecord } from "./tool-store.ts";
import { programWords } from "./words-of-program.ts";
import { wordsOfStep } from "./words-of-step.ts";
import { withFile, withMain, withoutFile, withText } from "./work.ts";

const cycle = cuttingCycles.find(({ number }) => number === 812);
const contourCycle = cuttingCycles.find(({ number }) => number === 810);
if (!cycle || !contourCycle) throw new Error("the catalogue lacks a cycle");
const job = exampleJob(cycle);
const TEXT = `0 BEGIN PGM A MM
1 TOOL CALL 1
2 CYCL DEF 812 SHOULDER ~
 Q460=+2 ~
 Q463=+3
3 L X+50 Z+2 FMAX
4 CYCL CALL
5 L X+60 FMAX
6 M30
7 END PGM A MM
`;
const file = (name: string, text = TEXT) => ({ name, text, encoding: "utf-8" as const });
const newest = (): HistoryStep => {
  const step = useSteps.getState().newest;
  if (!step) throw new Error("nothing changed");
  return step;
};
const words = () => wordsOfStep(newest(), "past", en);

beforeEach(() => {
  toolRecord.replace(shippedList);
  ownRecord.replace([{ id: "c1", number: "1711", name: "SAW", parameters: [] }]);
  changeSettings(firstSettings());
  openFirstWork(job, "work");
});

const row = (id: string, cells: object) =>
  editTools((list) => list.map((e) => (e.id === id ? { ...e, cells: { ...e.cells, ...cells } } : e)));

test.each<[string, () => unknown]>([
  ["Q463 3 → 5", () => setPrompt("Q463", "5")],
  ["Q463 3 → –", () => setPrompt("Q463", "")],
  ["Q460 2 → 4, Q463 3 → 5", () => setPrompts({ Q460: "4", Q463: "5" })],
  ["Q460 2 → 4 and 2 more", () => setPrompts({ Q460: "4", Q463: "5", Q478: "0.7" })],
  ["Q5 – → 3.1", () => setParameter("Q5", "3.1")],
  [`T ${job.tool} → 8`, () => setPlace("tool", "8")],
  [`blank ⌀ ${job.blank.outside} → 81`, () => setPlace("blank.outside", "81")],
  [`start X ${job.start.x} → 91`, () => setPlace("start.x", "91")],
  ["VC 180 → 165", () => setSpindle("cuttingSpeed", "165")],
  ["spindle changed", () => setSpindle("mode", "constant")],
  ["M136 off", () => setPerRevolution(false)],
  [`name ${job.name} → B`, () => setName("B")],
  ["material changed", () => setMaterial("c45")],
  ["cycle 812 → 822", () => changeJob((now) => ({ ...now, cycle: 822 }))],
  [
    "Q463 3 → 5, T 1 → 20",
    () => asOneStep(() => [setPlace("tool", "1"), setPrompt("Q463", "5"), setPlace("tool", "20")]),
  ],
  ["tool 3: RS 0.4 → 0.8", () => row("r3", { RS: "0.8" })],
  ["tool 3 changed", () => row("r3", { RS: "0.7", NAME: "X", T: "99" })],
  ["tool 4 deleted", () => editTools((list) => list.filter(({ id }) => id !== "r4"))],
  ["tool 77 added", () => editTools((list) => [...list, { id: "new", cells: { T: "77" } }])],
  ["2 tools deleted", () => editTools((list) => list.slice(2))],
  ["tool table changed", () => editTools((list) => [{ id: "new", cells: { T: "77" } }, ...list.slice(1)])],
  ["cycle 1712 added", () => editOwn((list) => [...list, { id: "c2", number: "1712", name: "", parameters: [] }])],
  ["cycle 1711: name SAW → CUT", () => editOwn((list) => list.map((each) => ({ ...each, name: "CUT" })))],
  ["control TNC 640 → TNC7", () => editSettings({ control: "TNC7" })],
  ["machine changed", () => editSettings({ machine: "{}" })],
])("%s", async (expected, change) => {
  await change();
  expect(words()).toBe(expected);
});

test("numbers are written as on the screen, names as they are", () => {
  setPrompts({ Q463: "5.5", Q478: "0.7" });
  expect(wordsOfStep(newest(), "past", de)).toBe("Q463 3 → 5,5, Q478 0,3 → 0,7");
  expect(wordsOfStep(newest(), "past", fr)).toBe("Q463 3 → 5,5, Q478 0,3 → 0,7");
  setPrompt("Q478", "Q5 + 0.1");
  expect(wordsOfStep(newest(), "past", de)).toBe("Q478 0,7 → Q5 + 0.1");
  setName("2.1");
  expect(wordsOfStep(newest(), "past", de)).toBe(`Name ${job.name} → 2.1`);
  row("r3", { NAME: "1.5" });
  expect(wordsOfStep(newest(), "past", de)).toContain("→ 1.5");
  const blank = "BLK FORM CYLINDER Z D100 L50\n";
  expect(programWords(parse(blank), parse(blank.replace("D100", "D90.5")), de)).toMatch(/D 100 → 90,5$/);
});

test("a step of a contour names its element", () => {
  const example = exampleJob(contourCycle),
    { contour } = example;
  openFirstWork(example, "contour");
  setContour(contour.map((each, i) => (i === 2 ? { ...each, z: "-17" } : each)));
  expect(words()).toBe(`element 3: Z ${contour[2]?.z ?? ""} → -17`);
  setContour(contour);
  setContour(contour.slice(0, 1));
  expect(words()).toBe(`${contour.length - 1} elements deleted`);
  setContour([]);
  expect(words()).toBe("element 1 deleted");
});

test.each<[string, Parameters<typeof changeProgram>[0]]>([
  ["skip blocks (/) on", (work) => ({ ...work, skipMarked: true })],
  ["file B.h added", (work) => withFile(work, file("B.h"))],
  ["file SUB.h deleted", (work) => withoutFile(work, "SUB.H")],
  ["file SUB.h: block 1: T 1 → 9", (work) => withText(work, "SUB.H", TEXT.replace("CALL 1", "CALL 9"))],
  ["main program A.h → SUB.h", (work) => withMain(work, "SUB.H")],
  ["block 1: T 1 → 9", (work) => ({ ...work, text: TEXT.replace("CALL 1", "CALL 9") })],
  ["name A.h → B.h", (work) => ({ ...work, name: "B.h" })],
])("in a program: %s", (expected, change) => {
  openFirstWork({ ...file("A.h"), files: [file("SUB.h")] }, "program");
  changeProgram(change);
  expect(words()).toBe(expected);
});

/** The text without numbers, so that blocks can be inserted and removed. */
const BARE = TEXT.replaceAll(/^\d+ /gm, "");
const OPERATION = "TOOL CALL 3\nCYCL DEF 861 RECESS ~\n Q460=+2\nL X+70\nCYCL CALL\n";
test.each([
  ["block 2: Q463 3 → 5", BARE, BARE.replace("Q463=+3", "Q463=+5")],
  ["block 3: X +50 → +52, Z +2 → +3", BARE, BARE.replace("X+50 Z+2", "X+52 Z+3")],
  ["cycle 861 inserted", BARE, BARE.replace("M30", `${OPERATION}M30`)],
  ["cycle 861 deleted", BARE.replace("M30", `${OPERATION}M30`), BARE],
  ["block 3 inserted", TEXT, TEXT.replace("3 L", "3 M8\n4 L").replace("4 CYCL", "5 CYCL").replace("5 L", "6 L")],
  ["block 5 deleted", BARE, BARE.replace("L X+60 FMAX\n", "")],
  ["blocks 3–5 deleted", BARE, BARE.replace(/L X\+50[^]*L X\+60 FMAX\n/, "")],
  ["block 4 changed", BARE, BARE.replace("CYCL CALL", "CYCL CALL ;NOW")],
  ["block 3 changed", BARE, BARE.replace("L X+50", "/L X+50")],
  ["block numbers changed", TEXT, TEXT.replaceAll(/^(\d+) /gm, (_, n: string) => `${Number(n) * 10} `)],
  ["program text changed", BARE, BARE.replace("M30", "\nM30")],
  [null, BARE, BARE],
])("in the text: %s", (expected, before, after) => {
  expect(programWords(parse(before), parse(after), en)).toBe(expected);
});

test("French participles agree", () => {
  const [bare, more] = [parse(BARE), parse(BARE.replace("M30", `${OPERATION}M30`))];
  expect(programWords(bare, more, fr)).toBe("cycle 861 inséré");
  expect(programWords(bare, parse(BARE.replace("L X+60 FMAX\n", "")), fr)).toBe("séquence 5 supprimée");
});

test.each([
  ["Annuler : outil 4 supprimé", fr, "Annuler"],
  ["Rückgängig: Werkzeug 4 gelöscht", de, "Rückgängig"],
  ["撤销：删除刀具 4", zh, "撤销"],
] as const)("%s", (expected, t, undo) => {
  editTools((list) => list.filter(({ id }) => id !== "r4"));
  const step = lastStep("tools");
  expect(step && t.step(undo, wordsOfStep(step, "past", t) ?? "")).toBe(expected);
});
