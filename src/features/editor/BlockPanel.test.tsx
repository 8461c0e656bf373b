import { act, cleanup, fireEvent, render, screen } from "@testing-library/react";
import { afterEach, beforeEach, expect, test } from "vitest";
import { changeLanguage } from "../../app/base/settings/settings.ts";
import { openFirstWork, useEditor } from "../../app/document/store.ts";
import { BlockPanel } from "./BlockPanel.tsx";
import { closeSession, openBlock, openSession } from "../../app/fields/blocks/session.ts";

/** Opens a program as its workplace does, a moment after the panel is rendered. */
function openProgram(text: string): void {
  act(() => {
    openFirstWork({ name: "A.H", text, encoding: "utf-8" }, "w");
    const { program } = useEditor.getState();
    if (program) openSession(program, "w");
  });
}

beforeEach(() => changeLanguage("en"));
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
