import { act, cleanup, fireEvent, render, screen, waitFor } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { afterEach, beforeEach, expect, onTestFinished, test, vi } from "vitest";
import { NOTICES } from "../app/base/waits.ts";
import { fetchTexts } from "../app/base/settings/loaded-texts.ts";
import { editTools, toolRecord, useTools } from "../app/document/tool-store.ts";
import { setPrompt } from "../app/document/edits.ts";
import { openFirstWork } from "../app/document/store.ts";
import { showTools, uncover } from "../app/place/place.ts";
import { cuttingCycles } from "../cycles/index.ts";
import { exampleJob } from "../program/job/job.ts";
import { shippedList } from "../program/tools/tool-list.ts";
import { ChangedElsewhere } from "./ChangedElsewhere.tsx";
import { UndoButtons } from "./UndoButtons.tsx";

const [cycle] = cuttingCycles;
if (!cycle) throw new Error("the catalogue is empty");

beforeEach(async () => {
  await fetchTexts("en", "first");
  toolRecord.replace(shippedList);
  openFirstWork(exampleJob(cycle), "work");
});
afterEach(cleanup);

const deleteTool = (id: string) => act(() => editTools((list) => list.filter((each) => each.id !== id)));

test("a change of another document is announced with its own undo, until that document is in view", async () => {
  render(<ChangedElsewhere />);
  deleteTool("r4");
  act(() => setPrompt("Q463", "5"));
  const undo = await screen.findByRole("button", { name: "Undo – Tool table: tool 4 deleted" });
  expect(screen.getAllByText(/:/)).toHaveLength(1);
  await userEvent.click(undo);
  expect(useTools.getState().list).toEqual(shippedList);
  expect(screen.queryByText(/Tool table/)).toBeNull();
  deleteTool("r5");
  await screen.findByText("Tool table: tool 5 deleted");
  act(() => showTools());
  expect(screen.queryByText(/Tool table/)).toBeNull();
  act(() => uncover());
  expect(screen.queryByText(/Tool table/)).toBeNull();
});

test("the announcement leaves by itself, but not while a pointer or the focus is on it", async () => {
  vi.useFakeTimers({ toFake: ["setTimeout", "clearTimeout"] });
  onTestFinished(() => void vi.useRealTimers());
  render(<ChangedElsewhere />);
  deleteTool("r4");
  const said = await vi.waitFor(() => screen.getByText("Tool table: tool 4 deleted"));
  const pass = (ms: number) => act(() => vi.advanceTimersByTime(ms));
  fireEvent.pointerEnter(said.parentElement ?? said);
  pass(2 * NOTICES.change);
  fireEvent.pointerLeave(said.parentElement ?? said);
  pass(NOTICES.change - 1);
  expect(screen.queryByText("Tool table: tool 4 deleted")).not.toBeNull();
  pass(1);
  expect(screen.queryByText("Tool table: tool 4 deleted")).toBeNull();
});

test("the buttons name the next step of each way, and are off without one", async () => {
  render(<UndoButtons document="work work" />);
  expect(screen.getByRole("button", { name: "Undo" })).toHaveProperty("disabled", true);
  act(() => setPrompt("Q463", "5"));
  const undo = await screen.findByRole("button", { name: /^Undo: Q463 .* → 5$/ });
  expect(undo.title).toMatch(/^Undo: Q463 .* → 5 \(Ctrl\+Z\)$/);
  await userEvent.click(undo);
  const redo = await screen.findByRole("button", { name: /^Redo: Q463 .* → 5$/ });
  expect(redo).toHaveProperty("disabled", false);
  const said = () => screen.getByRole("status").textContent;
  await waitFor(() => expect(said()).toMatch(/^Undone: Q463 .* → 5$/));
  await userEvent.click(redo);
  await waitFor(() => expect(said()).toMatch(/^Redone: Q463 .* → 5$/));
  act(() => setPrompt("Q463", "6"));
  expect(said()).toBe("");
});
