import { fireEvent, render, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test } from "vitest";
import { fetchRequested } from "../base/settings/loaded-texts.ts";
import { NARROWEST, useColumns } from "./columns.ts";
import { Splitter } from "./Splitter.tsx";

test("a separator is moved by keys, remembers its place for one workplace, and goes back with a double click", async () => {
  await fetchRequested("en");
  const user = userEvent.setup();
  const { container } = render(
    <main>
      <div className="left" />
      <Splitter of="program" side="left" />
    </main>,
  );
  const main = container.querySelector("main");
  const separator = screen.getByRole("separator", { name: "Width of the left column" });
  expect(separator.getAttribute("aria-valuenow")).toBe(String(NARROWEST.left));
  await user.tab();
  expect(document.activeElement).toBe(separator);
  await user.keyboard("{Home}");
  expect(useColumns.getState()).toEqual({ cycle: {}, program: { left: NARROWEST.left } });
  expect(main?.style.getPropertyValue("--left-width")).toBe(`${NARROWEST.left / 16}rem`);
  expect(localStorage.getItem("turnwise/columns")).toContain(String(NARROWEST.left));
  fireEvent.doubleClick(separator);
  expect(useColumns.getState().program.left).toBeUndefined();
  expect(main?.style.getPropertyValue("--left-width")).toBe("");
});
