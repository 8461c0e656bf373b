import { act, render, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test, vi } from "vitest";
import { at } from "../../../kernel/geometry/point.ts";
import { clock } from "../../base/clock.ts";
import { createEye, spaceProjection } from "../solid/eye.ts";
import { PlaceButtons } from "./PlaceButtons.tsx";
import type { PicturePlace } from "./places.ts";

const place: PicturePlace = {
  id: "f1",
  kind: "finding",
  mark: "1",
  place: at(-22.3, 20.6),
  bounds: { left: -24, right: -20, low: 20, high: 21 },
  line: "0.7 mm² of the part are cut away. (block 9)",
  position: { step: 3, fraction: 1 },
  issue: null,
};

test("a mark in the 3D view has a name, is chosen by keyboard, and stays at its place when the eye moves", async () => {
  const eye = createEye(clock, () => true),
    choose = vi.fn();
  eye.setSize({ width: 640, height: 400 });
  eye.setBounds({ left: -60, right: 2, low: 0, high: 22 });
  render(<PlaceButtons seeing={spaceProjection(eye, false)} places={[place]} chosen={null} choose={choose} />);
  const mark = screen.getByRole("button", { name: "1: 0.7 mm² of the part are cut away. (block 9)" });
  await userEvent.tab();
  expect(document.activeElement).toBe(mark);
  await userEvent.keyboard("{Enter}");
  expect(choose).toHaveBeenCalledWith(place);
  const left = () => 16 * Number.parseFloat(mark.style.left),
    before = left();
  act(() => eye.slide(31, 0));
  // A place nearer than the centre moves a little further.
  expect((left() - before) / 31).toBeCloseTo(1.05, 1);
  act(() => eye.slide(5000, 0));
  expect(screen.queryByRole("button")).toBeNull();
});
