import { cleanup, render } from "@testing-library/react";
import { afterEach, beforeEach, expect, test } from "vitest";
import { cycleByNumber } from "../../../cycles/index.ts";
import { never } from "../../../kernel/never.ts";
import { exampleJob } from "../../../program/job/job.ts";
import { possibleActions } from "../../base/actions.ts";
import { changeSettings } from "../../base/settings/settings.ts";
import { open } from "../../document/store.ts";
import type { Work } from "../../document/work.ts";
import { ProgramMenus } from "./ProgramMenus.tsx";

const program = { name: "TWO.H", text: "0 BEGIN PGM TWO MM\n1 END PGM TWO MM\n", encoding: "utf-8" as const };

/** Whether improvements are offered for a work, in the palette as in the menu. */
function offersImprovements(work: Work): boolean {
  open(work, "open");
  render(<ProgramMenus showBlock={() => undefined} files={[]} />);
  return possibleActions().some(({ id }) => id === "do.improve");
}

beforeEach(() => changeSettings({ language: "en" }));
afterEach(() => {
  cleanup();
  open(null, null);
});

test("improvements are offered for a program", () => {
  expect(offersImprovements(program)).toBe(true);
});

test("an exercise gets none: they would answer it", () => {
  expect(offersImprovements({ ...program, task: { id: "faster" } })).toBe(false);
});

test("a single cycle gets none", () => {
  expect(offersImprovements(exampleJob(cycleByNumber(812) ?? never("no such cycle")))).toBe(false);
});
