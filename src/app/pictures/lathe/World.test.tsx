import { act, cleanup, render } from "@testing-library/react";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { createViewport } from "./viewport.ts";
import { World } from "./World.tsx";

beforeEach(() => vi.useFakeTimers());
afterEach(() => {
  cleanup();
  vi.useRealTimers();
});

test("a redraw while panning is marked as coarse until the hand rests", () => {
  const viewport = createViewport(true);
  const { container } = render(
    <svg>
      <World viewport={viewport} shifts>
        <path d="M0 0" />
      </World>
    </svg>,
  );
  const isCoarse = () => container.querySelector("g")?.classList.contains("coarse");
  act(() => viewport.zoom(1.7));
  // What is drawn there is only shifted.
  expect(isCoarse()).toBe(false);
  act(() => viewport.zoom(1.7));
  expect(isCoarse()).toBe(true);
  act(() => void vi.advanceTimersByTime(500));
  expect(isCoarse()).toBe(false);
});
