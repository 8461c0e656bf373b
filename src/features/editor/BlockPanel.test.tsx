import { act, cleanup, fireEvent, render, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { afterEach, beforeEach, expect, test } from "vitest";
import { changeLanguage } from "../../app/base/settings/settings.ts";
import { documentOfWork } from "../../app/document/documents.ts";
import { undo } from "../../app/document/steps.ts";
import { openFirstWork, useEditor } from "../../app/document/store.ts";
import { BlockPanel } from "./BlockPanel.tsx";
import { closeSession, openBlock, openSession, sessionText } from "../../app/fields/blocks/session.ts";

/** Opens a program as its workplace does, a moment after the panel is rendered. */
function openProgram(text: string): void {
  act(() => {
    openFirstWork({ name: "A.H", text, encoding: "utf-8" }, "w");
    const { program } = useEditor.getState();
    if (program) openSession(program, "w");
  });
}

beforeEach(() => {
  // jsdom has no layout, but the text measures the rectangles of a range.
  Range.prototype.getClientRects ??= () => [] as unknown as DOMRectList;
  return changeLanguage("en");
});
afterEach(() => {
  cleanup();
  closeSession();
});

test("typing while a program opens goes on: nothing takes focus away", () => {
  render(
    <>
      <input aria-label="Answer" />
      <BlockPanel />
    </>,
  );
  const field = screen.getByRole("textbox");
  field.focus();
  expect(screen.queryByRole("group")).toBeNull();
  openProgram("");
  expect(screen.getByRole("group", { name: "Insert block" })).toBeTruthy();
  expect(document.activeElement).toBe(field);
});

test("the kinds of blocks get focus if nothing else has it", () => {
  render(<BlockPanel />);
  openProgram("");
  expect(screen.getByRole("group").contains(document.activeElement)).toBe(true);
});

test("Enter in the last word finishes the block: focus is at the next one, and one step back is the word before", async () => {
  const user = userEvent.setup();
  render(<BlockPanel />);
  openProgram("BEGIN PGM A MM\nL X+1 Z+2 FMAX\nEND PGM A MM\n");
  act(() => openBlock(1));
  const words = [...document.querySelectorAll<HTMLElement>("[data-word]")];
  expect(words.length).toBeGreaterThan(2);
  const last = words.at(-1);
  words[0]?.focus();
  for (const word of words) {
    expect(document.activeElement).toBe(word);
    if (word === last) await user.keyboard("M8");
    await user.keyboard("{Enter}");
  }
  expect(document.activeElement).toBe(screen.getByRole("button", { name: "Insert a block after this one" }));
  expect(sessionText()).toContain("L X+1 Z+2 FMAX M8");
  act(() => undo(documentOfWork("w")));
  expect(sessionText()).toContain("L X+1 Z+2 FMAX\n");
});

test("Enter in the last word of an operation by blocks leads on to the next operation", () => {
  render(<BlockPanel />);
  openProgram(
    "0 BEGIN PGM A MM\n1 TOOL CALL 47 Z S900\n2 CYCL DEF 240 CENTERING ~\n  Q201=-9 ;DEPTH ~\n  Q206=0.1 ;FEED\n3 CYCL CALL\n4 END PGM A MM\n",
  );
  act(() => openBlock(2));
  const last = screen.getAllByRole("textbox").at(-1);
  last?.focus();
  if (last) fireEvent.keyDown(last, { key: "Enter" });
  expect(document.activeElement?.textContent?.trim()).toBe("Insert operation");
  act(() => openBlock(3));
  expect(screen.queryByRole("button", { name: "Insert operation" })).toBeNull();
});
