import { undoStep } from "../../app/document/history.ts";
import { act, cleanup, fireEvent, render, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { useState } from "react";
import { afterEach, beforeAll, expect, test } from "vitest";
import { cuttingCycles } from "../../cycles/index.ts";
import { exampleJob, newRow, type ContourRow } from "../../program/job/job.ts";
import { setContour } from "../../app/document/edits.ts";
import { fetchTexts } from "../../app/base/settings/loaded-texts.ts";
import { historyOf } from "../../app/document/steps.ts";
import { openDocument, openFirstWork, useEditor } from "../../app/document/store.ts";
import { chooseElement } from "../../app/place/contour-place.ts";
import { ContourStage } from "./ContourStage.tsx";

const freeCycle = cuttingCycles.find(({ contour }) => contour === "free");
if (!freeCycle) throw new Error("no cycle with a contour table");

beforeAll(() => {
  SVGElement.prototype.setPointerCapture = () => undefined;
  SVGElement.prototype.hasPointerCapture = () => false;
  return fetchTexts("en");
});
afterEach(() => {
  cleanup();
  chooseElement(null);
});

const shaft = () => [
  newRow("e1", { x: "17.43", z: "0" }),
  newRow("e2", { z: "-23.6" }),
  newRow("e3", { x: "41.9" }),
  newRow("e4", { x: "58.07", z: "-51.3" }),
];

function shown(start: readonly ContourRow[] = shaft()) {
  const last = { rows: start, places: [] as (string | null)[] };
  function Page() {
    const [rows, setRows] = useState(start);
    return (
      <ContourStage
        rows={rows}
        blank={[]}
        language="en"
        lead={null}
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
const dimension = (name: RegExp) => screen.getByRole("button", { name });
const field = (name: string) => screen.queryByRole<HTMLInputElement>("textbox", { name });
const canvas = () => screen.getByRole("group", { name: "Contour drawing" });

test("arrows select an element, Tab goes to its dimensions, Enter opens one and applies it as one step", async () => {
  const user = userEvent.setup();
  const last = shown();
  canvas().focus();
  await user.keyboard("{ArrowRight}{ArrowRight}{ArrowRight}{Tab}");
  expect(document.activeElement).toBe(dimension(/^Element 4, X diameter/));
  await user.keyboard("{Enter}60-1.93{Enter}");
  expect(last.rows[3]).toMatchObject({ x: "58.07", z: "-51.3" });
  await user.keyboard("{Enter}55,5{Enter}");
  expect(last.rows[3]?.x).toBe("55,5");
  expect(last.places.at(-1)).toBeNull();
  expect(document.activeElement).toBe(dimension(/^Element 4, X diameter/));
});

test("Escape cancels a dimension, leaving its field applies it", async () => {
  const user = userEvent.setup();
  const last = shown();
  await user.click(dimension(/^Element 3, X diameter/));
  await user.keyboard("44.4{Escape}");
  expect(last.places).toEqual([]);
  expect(field("Element 3, X diameter, in the drawing")).toBeNull();
  await user.click(dimension(/^Element 3, X diameter/));
  await user.keyboard("44.4");
  fireEvent.blur(field("Element 3, X diameter, in the drawing") ?? document.body);
  expect(last.rows[2]?.x).toBe("44.4");
});

test("a drag that ends the typing of a dimension keeps the typed value, and is a separate step", async () => {
  const user = userEvent.setup();
  openFirstWork(exampleJob(freeCycle), "work");
  setContour(shaft());
  const Work = () => (
    <ContourStage
      rows={useEditor((s) => s.job?.contour) ?? []}
      blank={[]}
      language="en"
      lead={null}
      onChange={setContour}
    />
  );
  render(<Work />);
  const rows = () => useEditor.getState().job?.contour ?? [],
    picture = () => screen.getByRole("img", { name: /^Drawing of the contour/ });
  const steps = () => historyOf(openDocument()).past.length,
    begun = steps();
  const dot = [...picture().querySelectorAll("g.point")]
    .find((p) => p.querySelector("text")?.textContent === "4")
    ?.querySelector("circle");
  const from = { clientX: Number(dot?.getAttribute("cx")), clientY: Number(dot?.getAttribute("cy")) };
  const pointer = { button: 0, pointerId: 1, pointerType: "mouse" };
  await user.click(dimension(/^Element 3, X diameter/));
  await user.keyboard("44.43");
  fireEvent.pointerDown(picture(), { ...pointer, ...from });
  fireEvent.blur(field("Element 3, X diameter, in the drawing") ?? document.body);
  for (const by of [20, 41]) fireEvent.pointerMove(picture(), { ...pointer, ...from, clientX: from.clientX - by });
  fireEvent.pointerUp(picture(), pointer);
  expect(rows()[2]?.x).toBe("44.43");
  expect(rows()[3]?.z).not.toBe("-51.3");
  expect(steps()).toBe(begun + 2);
  // Dragged back and forth, then cancelled by Escape: there is nothing to undo.
  fireEvent.pointerDown(picture(), { ...pointer, clientX: from.clientX - 41, clientY: from.clientY });
  fireEvent.pointerMove(picture(), { ...pointer, clientX: from.clientX - 77, clientY: from.clientY + 20 });
  fireEvent.keyDown(document.body, { key: "Escape" });
  expect(steps()).toBe(begun + 2);
  act(() => undoStep());
  expect([rows()[2]?.x, rows()[3]?.z]).toEqual(["44.43", "-51.3"]);
});

test("solved values are in brackets, the constraints of an element are next to it", () => {
  shown([newRow("e1", { x: "20", z: "0" }), newRow("e2", { x: "26.4", angle: "135" }), newRow("e3", { z: "-31.7" })]);
  act(() => chooseElement("e2"));
  expect(screen.getByRole("button", { name: /^Element 2, Z: \(Z -3\.2\)$/ })).toBeTruthy();
  expect([...document.querySelectorAll(".hold")].map((e) => e.getAttribute("class")?.split(" ")[1])).toEqual([
    "sought",
    "horizontal",
  ]);
});

/** Rows as kind and typed coordinates. */
const rowTexts = (rows: readonly ContourRow[]) => rows.map(({ kind, x, z }) => `${kind} ${x}/${z}`);
const [first, second, third, fourth] = rowTexts(shaft());

test.each([
  ["R breaks the corner", ["ArrowRight", "r"], [first, second, "RND /", third, fourth]],
  ["U puts an undercut into the corner", ["ArrowRight", "u"], [first, second, "UDC /", third, fourth]],
  ["a corner that is not there stays", ["r", "u"], [first, second, third, fourth]],
  ["Alt and arrows move the point to the grid", ["Alt+ArrowLeft", "Alt+ArrowUp"], ["L 18/-1", second, third, fourth]],
  [
    "an omitted coordinate is written once the point leaves it",
    ["ArrowRight", "Alt+ArrowDown"],
    [first, "L 16/-23.6", third, fourth],
  ],
  ["N divides the next element", ["n"], [first, "L 17.43/-11.8", second, third, fourth]],
  [
    "N behind the last point adds one",
    ["ArrowDown", "ArrowDown", "ArrowDown", "n"],
    [first, second, third, fourth, "L 58.07/-52.3"],
  ],
  ["Delete removes the element", ["ArrowRight", "Delete", "Delete"], [first, fourth]],
])("keys of the drawing: %s", (_, keys, expected) => {
  const last = shown();
  act(() => chooseElement("e1"));
  canvas().focus();
  for (const key of keys) fireEvent.keyDown(canvas(), { key: key.replace("Alt+", ""), altKey: key.startsWith("Alt+") });
  expect(rowTexts(last.rows)).toEqual(expected);
  expect(document.activeElement).toBe(canvas());
});

test("the place of an element chosen or moved by keys is said, and its moves are one step", () => {
  const last = shown();
  const said = () => canvas().querySelector("[role=status]")?.textContent;
  canvas().focus();
  expect(said()).toBe("");
  for (const altKey of [false, true, true]) fireEvent.keyDown(canvas(), { key: "ArrowRight", altKey });
  expect(said()).toBe("Line 2  X ⌀ 17.43  Z -22");
  expect(new Set(last.places).size).toBe(1);
  fireEvent.blur(canvas());
  expect(said()).toBe("");
});

test("an empty drawing takes its first points by keys", () => {
  const last = shown([]);
  canvas().focus();
  for (const key of ["n", "n"]) fireEvent.keyDown(canvas(), { key });
  expect(rowTexts(last.rows)).toEqual(["L 0/0", "L 0/-1"]);
});

test("an empty drawing asks for the first point, which can be typed or drawn", async () => {
  const user = userEvent.setup();
  const last = shown([]);
  expect(screen.getByText("Set the first point of the contour here, or type it.")).toBeTruthy();
  const picture = screen.getByRole("img");
  fireEvent.pointerDown(picture, { button: 0, pointerId: 1, pointerType: "touch", clientX: 250, clientY: 90 });
  fireEvent.pointerUp(picture, { pointerId: 1 });
  expect(last.rows).toHaveLength(1);
  cleanup();
  const typed = shown([]);
  await user.click(screen.getByRole("button", { name: "Type the first point" }));
  expect(typed.rows).toEqual([newRow("e1")]);
});

test("a second finger cancels the gesture of the first and pans the picture", () => {
  const last = shown();
  const picture = screen.getByRole("img");
  const dot = [...picture.querySelectorAll("g.point")]
    .find((p) => p.querySelector("text")?.textContent === "4")
    ?.querySelector("circle");
  const at = { clientX: Number(dot?.getAttribute("cx")), clientY: Number(dot?.getAttribute("cy")) };
  const finger = (pointerId: number) => ({ button: 0, pointerId, pointerType: "touch" });
  fireEvent.pointerDown(picture, { ...finger(1), ...at });
  fireEvent.pointerMove(picture, { ...finger(1), clientX: at.clientX - 30, clientY: at.clientY });
  expect(last.rows[3]?.z).not.toBe("-51.3");
  fireEvent.pointerDown(picture, { ...finger(2), clientX: at.clientX + 60, clientY: at.clientY });
  expect(last.rows).toEqual(shaft());
  const before = dot?.getAttribute("cx");
  fireEvent.pointerMove(picture, { ...finger(2), clientX: at.clientX + 120, clientY: at.clientY });
  expect(picture.querySelector("circle")?.isConnected && dot?.getAttribute("cx")).not.toBe(before);
  expect(last.rows).toEqual(shaft());
  fireEvent.pointerUp(picture, finger(1));
  fireEvent.pointerUp(picture, finger(2));
});
