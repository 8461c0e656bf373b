import { fireEvent } from "@testing-library/react";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { listenToGestures } from "./gestures.ts";
import { createViewport } from "./viewport.ts";

const hover = vi.fn(),
  tap = vi.fn();
const element = document.createElement("div");
element.setPointerCapture = () => undefined;
let deaf = () => undefined as void;
const mouse = (clientX: number, clientY: number, movementX = 0) => ({
  pointerType: "mouse",
  pointerId: 1,
  clientX,
  clientY,
  movementX,
});

beforeEach(() => {
  vi.clearAllMocks();
  document.body.append(element);
  deaf = listenToGestures(element, createViewport(true), { tap, hover });
});
afterEach(() => deaf());

test("a resting mouse is ignored, although the browser repeats its event after a layout", () => {
  fireEvent.pointerMove(element, mouse(31, 47, 7));
  fireEvent.pointerMove(element, mouse(31, 47));
  vi.spyOn(element, "getBoundingClientRect").mockReturnValue(new DOMRect(0, 13, 300, 200));
  fireEvent.pointerMove(element, mouse(31, 47));
  expect(hover.mock.calls).toEqual([[{ x: 31, y: 47 }]]);
  vi.restoreAllMocks();
  fireEvent.pointerMove(element, mouse(32, 47, 1));
  expect(hover).toHaveBeenLastCalledWith({ x: 32, y: 47 });
});

test("so is one under which the picture appears; one that enters, or comes back, is not", () => {
  fireEvent(element, new PointerEvent("pointerenter", { ...mouse(31, 47), movementX: 0, movementY: 0 }));
  fireEvent.pointerMove(element, mouse(31, 47));
  expect(hover).not.toHaveBeenCalled();
  fireEvent(element, new PointerEvent("pointerleave", mouse(31, 47)));
  expect(hover.mock.calls).toEqual([[null]]);
  fireEvent(element, new PointerEvent("pointerenter", { ...mouse(31, 47), movementX: 9 }));
  fireEvent.pointerMove(element, mouse(31, 47, 9));
  expect(hover).toHaveBeenLastCalledWith({ x: 31, y: 47 });
});
