import { undoStep, redoStep } from "../../document/history.ts";
import { useNotices } from "../../base/notices.ts";
import { beforeEach, expect, test, vi } from "vitest";
import { shippedTools } from "../../../program/tools/shipped-tools.ts";
import { engine } from "../../calculation/engine.ts";
import { forgetOutcome, takeOutcome } from "../../calculation/outcome.ts";
import { openFirstWork, changeProgram, useEditor } from "../../document/store.ts";
import { textsOf } from "../../document/work.ts";
import { closeProgramChoice, useProgramChoice } from "../../document/program-choice.ts";
import { plainFiles } from "../../records/files/file-handle.ts";
import { LARGEST_PROGRAM } from "../../base/limits.ts";
import { missingFiles } from "../../calculation/missing-files.ts";
import { addFiles, openFiles } from "./open-files.ts";
import { openDropped } from "./open-program.ts";
import { shownOtherFile, shownFile, showFile } from "../../document/shown-file.ts";

const pgm = (lines: string) => `0 BEGIN PGM S MM\n${lines}\nEND PGM S MM\n`;

/** Device files; jsdom needs its own way to read their bytes. */
function chosen(texts: Readonly<Record<string, string>>) {
  return plainFiles(
    Object.entries(texts).map(([name, text]) =>
      fileOf(name, async () => new TextEncoder().encode(text).buffer, text.length),
    ),
  );
}
const fileOf = (name: string, arrayBuffer: () => Promise<ArrayBuffer>, size: number) =>
  Object.defineProperties(new File([], name), { arrayBuffer: { value: arrayBuffer }, size: { value: size } });

const program = () => {
  const { program: open } = useEditor.getState();
  if (!open) throw new Error("no program is open");
  return open;
};
const names = () => textsOf(program()).map(({ name }) => name);
const calculate = () => {
  const { name, text, files = [] } = program();
  const table = { tools: shippedTools, mills: [], refused: new Map() };
  const outcome = engine.update({
    version: (version += 1),
    name,
    text,
    files,
    table,
    rapid: 10_000,
    control: "TNC 640",
  });
  takeOutcome(outcome);
  return outcome;
};
let version = 0;

beforeEach(() => {
  openFirstWork(null, null);
  forgetOutcome();
  showFile(null);
  useNotices.setState({ notices: [] });
  closeProgramChoice();
});

test("one file is a program alone; several are one work, and the one that no other calls runs", async () => {
  expect(await openFiles(chosen({ "a.h": pgm("L X+1") }))).toBe("opened");
  expect(program()).toEqual({ name: "a.h", text: pgm("L X+1"), encoding: "utf-8" });
  await openFiles(chosen({ "cut.h": pgm("L X+1"), "whole.h": pgm("CALL PGM CUT"), "p.tab": "1" }));
  expect(names()).toEqual(["whole.h", "cut.h", "p.tab"]);
  expect(useNotices.getState().notices).toEqual([]);
});

test("with several programs that no other calls, it asks which to open", async () => {
  const texts = {
    "a.h": pgm("CALL PGM SUB"),
    "b.h": pgm("L X+2\nCALL PGM TNC:\\sub\\SUB.H"),
    "sub.h": pgm("L X+3"),
    "p.tab": "1",
  };
  const choice = () => {
    const { choice: asked } = useProgramChoice.getState();
    if (!asked) throw new Error("nothing is asked");
    return asked;
  };
  expect(await openFiles(chosen(texts))).toBe("opened");
  expect(useEditor.getState().program).toBeNull();
  expect(choice().works.map((work) => textsOf(work).map(({ name }) => name))).toEqual([
    ["a.h", "sub.h"],
    ["b.h", "sub.h"],
  ]);
  choice().open(choice().works);
  await vi.waitFor(() => expect(names()).toEqual(["a.h", "sub.h"]));
  choice().together();
  expect(names()).toEqual(["a.h", "b.h", "sub.h", "p.tab"]);
  expect(useNotices.getState().notices).toEqual([]);
});

test("programs that all call each other are one work, with a notice that the main program is unclear", async () => {
  await openFiles(chosen({ "a.h": pgm("CALL PGM B"), "b.h": pgm("CALL PGM A") }));
  expect(names()).toEqual(["a.h", "b.h"]);
  expect(useNotices.getState().notices).toEqual(["mainUnsure"]);
});

test("of two files with one name the first counts", async () => {
  await openFiles(chosen({ "a.h": pgm("CALL PGM B"), "b.h": pgm("L X+1"), "B.H": pgm("L X+2") }));
  expect(textsOf(program()).map(({ name, text }) => [name, text.includes("X+1")])).toEqual([
    ["a.h", false],
    ["b.h", true],
  ]);
});

test("an unreadable file gives a notice, and the others are opened", async () => {
  const broken = plainFiles([fileOf("folder", () => Promise.reject(new Error("a folder")), 10)]);
  expect(await openFiles([...chosen({ "a.h": pgm("L X+1") }), ...broken])).toBe("opened");
  expect(names()).toEqual(["a.h"]);
  expect(useNotices.getState().notices).toEqual(["fileUnreadable"]);
  expect(await openFiles(broken)).toBe("unreadable");
  expect(names()).toEqual(["a.h"]);
});

test("files that are too large together are neither opened nor added to a program", async () => {
  const large = plainFiles(
    ["a.h", "b.h"].map((name) => fileOf(name, async () => new ArrayBuffer(1), LARGEST_PROGRAM / 2 + 1)),
  );
  expect(await openFiles(large)).toBe("tooLarge");
  expect(useEditor.getState().program).toBeNull();
  await openFiles(chosen({ "main.h": pgm("CALL PGM A") }));
  await addFiles(large);
  expect(names()).toEqual(["main.h"]);
  expect(useNotices.getState().notices).toEqual(["fileTooLarge"]);
});

test("a called file is missing until it is added, which is one step of undo", async () => {
  await openFiles(
    chosen({ "main.h": pgm("CALL PGM TNC:\\work\\cut\nCALL PGM CUT.H\nCALL PGM B"), "b.h": pgm("L X+1") }),
  );
  const outcome = calculate();
  expect(missingFiles(program(), outcome)).toEqual(["CUT.H"]);
  await addFiles(chosen({ "cut (1).h": pgm("L X+2") }), "CUT.H");
  expect(names()).toEqual(["main.h", "b.h", "CUT.H"]);
  expect(missingFiles(program(), outcome)).toEqual([]);
  expect(missingFiles(program(), calculate())).toEqual([]);
  undoStep();
  expect(names()).toEqual(["main.h", "b.h"]);
  redoStep();
  expect(names()).toEqual(["main.h", "b.h", "CUT.H"]);
});

test("a missing file dropped on a program is added to it; any other file opens as a new work", async () => {
  const drop = (texts: Readonly<Record<string, string>>) =>
    openDropped({
      items: [],
      files: chosen(texts).map(({ file }) => file),
      getData: () => "",
    } as unknown as DataTransfer);
  await openFiles(chosen({ "main.h": pgm("CALL PGM CUT\nCALL PGM B") }));
  calculate();
  const { work } = useEditor.getState();
  await drop({ "cut.h": pgm("L X+1") });
  expect(names()).toEqual(["main.h", "cut.h"]);
  expect(useEditor.getState().work).toBe(work);
  calculate();
  await drop({ "b.h": pgm("CALL PGM C"), "c.h": pgm("L X+2") });
  expect(names()).toEqual(["b.h", "c.h"]);
  expect(useEditor.getState().work).not.toBe(work);
});

test("the main program is shown if the shown file is not part of the work", async () => {
  await openFiles(chosen({ "main.h": pgm("CALL PGM CUT"), "cut.h": pgm("L X+1") }));
  expect(shownFile(program()).name).toBe("main.h");
  showFile("CUT.H");
  expect([shownFile(program()).name, shownOtherFile()?.name]).toEqual(["cut.h", "cut.h"]);
  changeProgram(({ files: _, ...rest }) => rest);
  expect([shownFile(program()).name, shownOtherFile()]).toEqual(["main.h", null]);
  undoStep();
  expect(shownOtherFile()?.name).toBe("cut.h");
});
