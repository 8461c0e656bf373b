import { render, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test, vi } from "vitest";
import { itemByKey, Menu } from "./Menu.tsx";

const NAMES = ["Download", "Setup sheet", "Share"];

test.each([
  ["ArrowDown", 0, 1],
  ["ArrowDown", 2, 0],
  ["ArrowUp", 0, 2],
  ["Home", 2, 0],
  ["End", 0, 2],
  ["s", 0, 1],
  ["s", 1, 2],
  ["s", 2, 1],
  ["x", 0, null],
  ["Enter", 0, null],
])("%s on item %d goes to %s", (key, at, to) => {
  expect(itemByKey(key, at, NAMES)).toBe(to);
});

test("a menu is used by keyboard, and its button has the focus afterwards", async () => {
  const user = userEvent.setup();
  const go = vi.fn();
  render(<Menu name="Export" groups={[[{ name: "Download", go }], [], [{ name: "Share", go }]]} />);
  const button = screen.getByRole("button", { name: "Export" });
  await user.tab();
  await user.keyboard("{ArrowDown}");
  expect(document.activeElement).toBe(screen.getByRole("menuitem", { name: "Download", hidden: true }));
  expect(screen.getAllByRole("group", { hidden: true })).toHaveLength(2);
  await user.keyboard("{Escape}");
  expect(screen.queryByRole("menu", { hidden: true })).toBeNull();
  expect(document.activeElement).toBe(button);
  await user.keyboard("{Enter}{End}{Enter}");
  expect(go).toHaveBeenCalledTimes(1);
  expect(screen.queryByRole("menu", { hidden: true })).toBeNull();
  expect(document.activeElement).toBe(button);
});
