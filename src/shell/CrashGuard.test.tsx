import { cleanup, render, screen } from "@testing-library/react";
import { afterEach, expect, test, vi } from "vitest";
import { CrashGuard } from "./CrashGuard.tsx";
import { useReports } from "../app/records/reports.ts";
import { changeSettings } from "../app/base/settings/settings.ts";

afterEach(cleanup);

function Broken(): never {
  throw new Error("planted");
}

test("a page that fails says that the work is saved, and offers ways back", () => {
  changeSettings({ language: "en" });
  const quiet = vi.spyOn(console, "error").mockImplementation(() => undefined);
  render(
    <CrashGuard>
      <Broken />
    </CrashGuard>,
  );
  expect(screen.getByRole("alert").textContent).toContain("Your program is saved on this device.");
  expect(screen.getAllByRole("button").map((b) => b.textContent)).toEqual(["Reload the page", "Go to the start page"]);
  expect(useReports.getState().list[0]).toMatchObject({
    message: "Error: planted",
    stack: expect.stringContaining("Broken"),
  });
  quiet.mockRestore();
});
