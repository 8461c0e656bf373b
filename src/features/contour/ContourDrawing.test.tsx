import { cleanup, fireEvent, render, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { useState } from "react";
import { afterEach, beforeAll, expect, test } from "vitest";
import { newRow, type ContourRow } from "../../program/job/job.ts";
import { fetchTexts } from "../../app/base/settings/loaded-texts.ts";
import { chooseElement } from "../../app/place/contour-place.ts";
import { ContourTable } from "./ContourTable.tsx";

beforeAll(() => {
  SVGElement.prototype.setPointerCapture = () => undefined;
  SVGElement.prototype.hasPointerCapture = () => false;
  return fetchTexts("en");
});
afterEach(() => {
  cleanup();
  chooseElement(null);
});

const shoulder = () => [
  newRow("e1", { x: "20", z: "0" }),
  newRow("e2", { z: "-20" }),
  newRow("e3", { x: "60" }),
  newRow("e4", { z: "-50" }),
];

function shown(start: readonly ContourRow[] = shoulder()) {
  const last = { rows: start, places: [] as (string | null)[] };
  function Page() {
    const [rows, setRows] = useState(start);
    return (
      <ContourTable
        rows={rows}
        language="en"
        onChange={(next, place) => {
          last.rows = next;
          last.places.push(place);
          setRows(next);
        }}
      />
    );
  }
  render(<Page />);
  return last;
}
const short = (rows: readonly ContourRow[]) => rows.map((r) => `${r.kind} ${r.x}/${r.z}${r.r && ` ${r.r}`}`);
const field = (name: string) => screen.getByRole<HTMLInputElement>("textbox", { name });
const picture = () => screen.getByRole("img", { name: /^Drawing of the contour/ });
/** Position of a row's mark; jsdom has no layout, so the picture begins at 0, 0 of the page. */
function mark(row: number) {
  const g = [...picture().querySelectorAll("g.point")].find(
    (p) => p.querySelector("text")?.textContent === String(row + 1),
  );
  const dot = g?.querySelector("circle");
  return { clientX: Number(dot?.getAttribute("cx")), clientY: Number(dot?.getAttribute("cy")) };
}
function drag(from: { clientX: number; clientY: number }, dx: number, dy: number, end = true) {
  const options = { button: 0, pointerId: 1, pointerType: "mouse" };
  fireEvent.pointerDown(picture(), { ...options, ...from });
  for (const k of [0.5, 1])
    fireEvent.pointerMove(picture(), { ...options, clientX: from.clientX + dx * k, clientY: from.clientY + dy * k });
  if (end) fireEvent.pointerUp(picture(), options);
}

test("a dragged point snaps to the grid as one step of undo, and Escape cancels the drag", () => {
  const last = shown();
  const [a, b] = [mark(0), mark(3)],
    scale = (a.clientX - b.clientX) / 50;
  drag(mark(3), -10.2 * scale, 0);
  expect(short(last.rows)[3]).toBe("L /-60");
  expect(new Set(last.places).size).toBe(1);
  drag(mark(3), -20 * scale, 0, false);
  fireEvent.keyDown(document.body, { key: "Escape" });
  expect(short(last.rows)[3]).toBe("L /-60");
});

test("a corner is rounded or chamfered by one drag, never larger than it fits", async () => {
  const user = userEvent.setup();
  const last = shown();
  await user.click(screen.getByRole("button", { name: "Round corners: drag a corner" }));
  const scale = (mark(0).clientX - mark(3).clientX) / 50;
  drag(mark(1), 4 * scale, 0);
  expect(short(last.rows)).toEqual(["L 20/0", "L /-20", "RND / 4", "L 60/", "L /-50"]);
  await user.click(screen.getByRole("button", { name: "Chamfer corners: drag a corner" }));
  drag(mark(1), 500, 0);
  expect(short(last.rows)[2]).toBe("CHF / 20");
  drag(mark(1), 0, 6);
  expect(short(last.rows)[2]).toMatch(/^CHF/);
});

test("drawing adds points, and a double click divides an element", async () => {
  const user = userEvent.setup();
  const last = shown();
  const [one, two] = [mark(0), mark(1)];
  const element = picture().querySelector('[data-row="1"] .reach');
  if (!element) throw new Error("no element");
  const middle = { clientX: (one.clientX + two.clientX) / 2, clientY: one.clientY };
  fireEvent.pointerDown(element, { button: 0, pointerId: 1, pointerType: "mouse", ...middle });
  fireEvent.pointerUp(element, { pointerId: 1 });
  fireEvent.doubleClick(element, middle);
  expect(short(last.rows)).toEqual(["L 20/0", "L 20/-10", "L /-20", "L 60/", "L /-50"]);
  await user.click(screen.getByRole("button", { name: /^Draw:/ }));
  fireEvent.pointerDown(picture(), { button: 0, pointerId: 1, pointerType: "mouse", clientX: 30, clientY: 200 });
  fireEvent.pointerUp(picture(), { pointerId: 1 });
  expect(last.rows).toHaveLength(6);
});

test("keyboard: R and C break the corner, T is tangential, a question mark leaves a coordinate open", async () => {
  const user = userEvent.setup();
  const last = shown();
  await user.click(field("Element 2, Z"));
  await user.keyboard("r");
  expect(short(last.rows)[2]).toBe("RND / 1");
  expect(document.activeElement).toBe(field("Element 3, radius"));
  await user.keyboard("2.5c");
  expect(short(last.rows)[2]).toBe("CHF / 2.5");
  await user.click(field("Element 4, X diameter"));
  await user.keyboard("t");
  expect(last.rows[3]?.tangent).toBe(true);
  await user.keyboard("t");
  await user.clear(field("Element 2, Z"));
  await user.type(field("Element 2, Z"), "?");
  expect(screen.getByText("1 value missing")).toBeTruthy();
  await user.clear(field("Element 2, Z"));
  await user.type(field("Element 2, Z"), "QR1");
  expect(last.rows[1]?.z).toBe("QR1");
});

test("angle and length: a solved value is the placeholder of its field and is read out as solved", async () => {
  const user = userEvent.setup();
  const last = shown([newRow("e1", { x: "40", z: "0" }), newRow("e2", { x: "60" })]);
  await user.click(screen.getByRole("button", { name: "Angle and length" }));
  expect(field("Element 2, length").placeholder).toBe("10");
  await user.type(field("Element 2, angle"), "135");
  expect(last.rows[1]).toMatchObject({ angle: "135", x: "60", z: "" });
  expect(field("Element 2, Z").placeholder).toBe("-10");
  expect(field("Element 2, Z").closest(".solved")).not.toBeNull();
  const about = (field("Element 2, Z").getAttribute("aria-describedby") ?? "")
    .split(" ")
    .map((id) => document.getElementById(id)?.textContent);
  expect(about).toContain("calculated: -10");
});

test("two solutions: the other one is a button away", async () => {
  const user = userEvent.setup();
  const last = shown([newRow("e1", { x: "20", z: "0" }), newRow("e2", { x: "26", length: "5" })]);
  expect(field("Element 2, Z").placeholder).toBe("-4");
  await user.click(screen.getByRole("button", { name: "Element 2, use the other solution" }));
  expect(last.rows[1]?.second).toBe(true);
  expect(field("Element 2, Z").placeholder).toBe("4");
});

test("faults are listed under the drawing, marked at their elements, and lead to them", async () => {
  const user = userEvent.setup();
  shown([...shoulder(), newRow("e5", { x: "10", z: "-10" })]);
  const list = screen.getByRole("list", { name: "Contour errors" });
  expect(within(list).getByRole("button").textContent).toContain("Element 5 crosses element 2");
  expect(picture().querySelectorAll(".faulty .element")).toHaveLength(2);
  await user.click(within(list).getByRole("button"));
  expect(document.activeElement).toBe(field("Element 5, X diameter"));
});

test("an undercut has its form and its words", async () => {
  const user = userEvent.setup();
  const last = shown([
    newRow("e1", { x: "40", z: "0" }),
    newRow("e2", { z: "-30" }),
    newRow("e3"),
    newRow("e4", { x: "60" }),
  ]);
  await user.selectOptions(screen.getByRole("combobox", { name: "Element 3, kind" }), "UDC");
  await user.type(field("Element 3, DEPTH"), "2");
  expect(last.rows[2]).toMatchObject({ kind: "UDC", form: "E", words: { DEPTH: "2" } });
  await user.selectOptions(screen.getByRole("combobox", { name: "Element 3, form" }), "THREAD");
  expect(field("Element 3, PITCH")).toBeTruthy();
});

test("a dragged polar point changes distance and angle, and a double click divides its element", () => {
  const last = shown([
    newRow("e1", { x: "20", z: "0" }),
    newRow("e2", { kind: "CC", x: "20", z: "-30" }),
    newRow("e3", { kind: "LP", words: { PR: "20", PA: "0" } }),
    newRow("e4", { kind: "LP", words: { PR: "20", PA: "90" } }),
  ]);
  const scale = (mark(0).clientX - mark(2).clientX) / 10;
  drag(mark(3), 0, -5.1 * scale);
  expect(last.rows[3]?.words).toEqual({ PR: "25", PA: "90" });
  const element = picture().querySelector('[data-row="2"] .reach');
  if (!element) throw new Error("no element");
  const middle = { clientX: (mark(0).clientX + mark(2).clientX) / 2, clientY: mark(0).clientY };
  fireEvent.pointerDown(element, { button: 0, pointerId: 1, pointerType: "mouse", ...middle });
  fireEvent.pointerUp(element, { pointerId: 1 });
  fireEvent.doubleClick(element, middle);
  expect(last.rows.map((r) => r.kind)).toEqual(["L", "CC", "L", "LP", "LP"]);
  expect(last.rows[3]?.words).toEqual({ PR: "20", PA: "0" });
});
