import { cleanup, render, screen, within } from "@testing-library/react";
import { afterEach, beforeEach, expect, test } from "vitest";
import { parse } from "../../../nc/parse.ts";
import { readingOfBlock } from "../blocks/block-prompts.ts";
import { openPrompt } from "../../place/place.ts";
import { changeSettings } from "../../base/settings/settings.ts";
import { CycleDialog } from "./CycleDialog.tsx";

const program = parse("0 BEGIN PGM A MM\n1 M136\n2 CYCL DEF 800 Q532=+750\n3 CYCL DEF 801\n4 END PGM A MM\n");
const nothing = () => undefined;

function show(index: number, prompt: string | null): void {
  const read = readingOfBlock(program, index, {});
  if (!read) throw new Error("no cycle of the catalogue");
  openPrompt(prompt, "");
  render(<CycleDialog read={read} block={{ line: index + 1, problems: [], set: nothing, setAll: nothing }} />);
}

beforeEach(() => changeSettings({ language: "en" }));
afterEach(cleanup);

test("the feed of the swivelling axes stays one per minute behind M136", () => {
  show(2, "Q532");
  expect(within(screen.getByRole("region", { name: "Active prompt" })).getByText("mm/min")).toBeDefined();
});

test("a cycle without prompts says so, and has no way back to one", () => {
  show(3, null);
  expect(screen.getByRole("heading", { name: "This cycle has no prompts" })).toBeDefined();
  expect(screen.queryByRole("button", { name: "Back to the first prompt" })).toBeNull();
  expect(screen.getByText(/effective from its definition/)).toBeDefined();
});
