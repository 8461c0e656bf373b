import { cleanup, render, screen, waitFor, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { part } from "../../kernel/geometry/point.ts";
import { at } from "../../kernel/geometry/point.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { tryWay } from "../../report/which/try-way.ts";
import { waysFor } from "../../report/which/ways.ts";
import { changeSettings } from "../../app/base/settings/settings.ts";
import { openFirstWork, useEditor } from "../../app/document/store.ts";
import type { Comparer } from "../../app/calculation/comparison.ts";
import type { WhichRegion } from "../../app/place/place.ts";
import { WhichCycle } from "./WhichCycle.tsx";

/** Does the worker's job in this thread. */
const direct: Comparer = {
  ways: (wanted, stock) => Promise.resolve(waysFor(wanted, stock, shippedTools)),
  tryWay: (proposal, wanted, stock) =>
    Promise.resolve(tryWay(proposal, wanted, stock, { tools: shippedTools, rapid: 10_000 })),
};

beforeEach(() => {
  changeSettings({ language: "en" });
  openFirstWork(null, null);
  HTMLDialogElement.prototype.showModal = function open(this: HTMLDialogElement) {
    this.open = true;
  };
  HTMLDialogElement.prototype.close = function close(this: HTMLDialogElement) {
    this.open = false;
    this.dispatchEvent(new Event("close"));
  };
});
afterEach(cleanup);

const shown = (region: WhichRegion | null = null) => {
  const done = vi.fn();
  render(<WhichCycle done={done} region={region} comparison={direct} />);
  return done;
};
const field = (name: string) => screen.findByRole<HTMLInputElement>("textbox", { name });
const type = async (name: string, text: string) => {
  const input = await field(name);
  await userEvent.clear(input);
  await userEvent.type(input, text);
};
const ways = () => screen.findByRole("list", { name: "Options, the best first" });
/** Waits until the shown proposals belong to the current question. */
const settled = async () => {
  const list = await ways();
  await waitFor(() => expect(list.getAttribute("aria-busy")).toBe("false"));
};
const best = () => screen.findByText(/^Best: /);

test("the proposals for a step are compared, the best is named, and using one starts its work", async () => {
  const done = shown();
  await best();
  const cards = within(await ways())
    .getAllByRole("listitem")
    .filter((card) => within(card).queryByRole("heading"));
  expect(cards.length).toBeGreaterThan(3);
  const first = within(cards[0] as HTMLElement);
  expect(first.getByText("Best")).toBeDefined();
  expect(first.getByText("Verified")).toBeDefined();
  await type("To ⌀", "41.37");
  await settled();
  await userEvent.click(within(await ways()).getAllByRole("button", { name: /^Use: / })[0] as HTMLElement);
  expect(done).toHaveBeenCalled();
  const { job } = useEditor.getState();
  expect(Object.values(job?.drafts[job.cycle] ?? {})).toContain("41.37");
});

test("an invalid value is reported at its field, and nothing is compared meanwhile", async () => {
  shown();
  await best();
  await type("To ⌀", "80");
  expect(await screen.findByText(/this ⌀ must be smaller than the first/)).toBeDefined();
  expect(screen.queryByRole("list", { name: "Options, the best first" })).toBeNull();
  await type("To ⌀", "1x");
  expect((await field("To ⌀")).getAttribute("aria-invalid")).toBe("true");
  await type("To ⌀", "40,5");
  await best();
});

test("another shape asks for its own numbers, and a groove that is too narrow says so", async () => {
  shown();
  await userEvent.selectOptions(await screen.findByRole("combobox", { name: "Shape" }), "groove");
  await best();
  await type("To Z", "-15.7");
  expect(await screen.findByText("None of these options is free of errors.")).toBeDefined();
  await userEvent.selectOptions(screen.getByRole("combobox", { name: "Shape" }), "thread");
  expect(await field("Thread ⌀")).toBeDefined();
  expect(await field("Pitch")).toBeDefined();
  expect(screen.queryByRole("textbox", { name: "To ⌀" })).toBeNull();
});

test("in an open work two elements of the contour are selected, and the wanted shape follows", async () => {
  const corners = [at(0, 15), at(-18.3, 15), at(-18.3, 24.2), at(-37.9, 24.2), at(-37.9, 35)];
  const contour = corners.slice(1).map((to, i) => part.line(corners[i] ?? to, to));
  shown({ contour, first: 0, last: 3, site: "outside", stock: [], initialStock: "solid" });
  expect(await screen.findByRole("img", { name: /4 elements; 1 to 4/ })).toBeDefined();
  await best();
  await userEvent.selectOptions(screen.getByRole("combobox", { name: "From element" }), "3");
  expect(screen.getByRole("img", { name: /3 to 4/ })).toBeDefined();
  await settled();
  await userEvent.click(within(await ways()).getAllByRole("button", { name: /^Use: / })[0] as HTMLElement);
  expect(useEditor.getState().job?.contour.map((row) => [row.x, row.z])).toEqual([
    ["48.4", "-18.3"],
    ["48.4", "-37.9"],
    ["70", "-37.9"],
  ]);
});

test("a thread is asked for by its name: its sizes, its insert and its side follow, until a number is changed", async () => {
  const done = shown();
  await userEvent.selectOptions(await screen.findByRole("combobox", { name: "Shape" }), "thread");
  const name = await screen.findByRole("combobox", { name: "Thread" });
  await userEvent.type(name, "M10 6H{Enter}");
  expect(screen.getByRole<HTMLSelectElement>("combobox", { name: "Where" }).value).toBe("inside");
  expect(screen.getByText("This is M10 6H · Middle of tolerance")).toBeDefined();
  await userEvent.type(name, "G1/2 A{Enter}");
  expect((await field("Pitch")).value).toBe("1.814");
  expect(screen.getByText("This is G1/2 A · Middle of tolerance")).toBeDefined();
  await settled();
  expect(screen.getAllByText(/has 60°; this thread requires 55°/).length).toBeGreaterThan(0);
  expect(screen.getByText("None of these options is free of errors.")).toBeDefined();
  await userEvent.click(within(await ways()).getAllByRole("button", { name: /^Use: / })[0] as HTMLElement);
  const { job } = useEditor.getState();
  expect(done).toHaveBeenCalled();
  expect(job?.drafts[job.cycle]).toMatchObject({ Q472: "1.814", Q473: "1.127", Q491: "20.813" });
});
