import { act, cleanup, render, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { afterEach, beforeEach, expect, test } from "vitest";
import { never } from "../../kernel/never.ts";
import { workplace as en } from "../../i18n/en/workplace.ts";
import { parse } from "../../nc/parse.ts";
import { filesByName } from "../../program/state/program-files.ts";
import { run } from "../../program/run/run.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { simulate } from "../../sim/simulate.ts";
import { forgetOutcome, takeOutcome } from "../../app/calculation/outcome.ts";
import { changeSettings } from "../../app/base/settings/settings.ts";
import { openFirstWork, useEditor } from "../../app/document/store.ts";
import { filesOf } from "../../app/document/work.ts";
import { WorkFiles } from "./WorkFiles.tsx";

const BESIDE = {
  name: "DEFINES.H",
  text: "0 BEGIN PGM DEFINES MM\n1 END PGM DEFINES MM\n",
  encoding: "utf-8",
} as const;
const MAIN = {
  name: "MAIN.H",
  text: "0 BEGIN PGM MAIN MM\n1 CALL PGM DEFINES\n2 M30\n3 END PGM MAIN MM\n",
  encoding: "utf-8",
} as const;
let version = 0;

/** Simulates the worker's answer for the open work. */
function answer(): void {
  const program = useEditor.getState().program ?? never("no program");
  const files = filesOf(program);
  const made = run(parse(program.text), { tools: shippedTools, rapid: 10_000, files: filesByName(files, parse) });
  act(() => takeOutcome({ version: ++version, text: program.text, files, run: made, simulation: simulate(made) }));
}

beforeEach(() => {
  changeSettings({ language: "en" });
  forgetOutcome();
  openFirstWork({ ...MAIN, files: [BESIDE] }, "w");
});
afterEach(cleanup);

test("focus stays in the list of files while the program runs without the last of them", async () => {
  const t = en.editor.files;
  render(<WorkFiles />);
  answer();
  const user = userEvent.setup();
  await user.click(screen.getByRole("button", { name: t.remove(BESIDE.name) }));
  expect(document.activeElement).toBe(screen.getByRole("button", { name: t.show(MAIN.name) }));
  answer();
  expect(document.activeElement).toBe(screen.getByRole("button", { name: t.show(MAIN.name) }));
  expect(screen.getByRole("button", { name: t.addOne("DEFINES.H") })).toBeTruthy();
});

test("focus stays in the list when the last file is removed before the current program has run at all", async () => {
  const t = en.editor.files;
  render(<WorkFiles />);
  answer();
  // Another file is the main program, so no earlier result counts.
  act(forgetOutcome);
  await userEvent.setup().click(screen.getByRole("button", { name: t.remove(BESIDE.name) }));
  expect(document.activeElement).toBe(screen.getByRole("button", { name: t.show(MAIN.name) }));
  answer();
  expect(document.activeElement).toBe(screen.getByRole("button", { name: t.show(MAIN.name) }));
});

test("a work of one file has no list, even right after a work with more files", () => {
  render(<WorkFiles />);
  answer();
  act(() => {
    forgetOutcome();
    openFirstWork({ ...BESIDE }, "v");
  });
  expect(screen.queryByRole("region")).toBeNull();
});
