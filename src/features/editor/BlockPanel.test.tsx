import { act, cleanup, render, screen } from "@testing-library/react";
import { afterEach, beforeEach, expect, test } from "vitest";
import { changeLanguage } from "../../app/base/settings/settings.ts";
import { openFirstWork, useEditor } from "../../app/document/store.ts";
import { BlockPanel } from "./BlockPanel.tsx";
import { closeSession, openSession } from "../../app/fields/blocks/session.ts";

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
