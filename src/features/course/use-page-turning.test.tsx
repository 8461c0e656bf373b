import { act, fireEvent, render, screen } from "@testing-library/react";
import { useRef } from "react";
import { expect, test } from "vitest";
import { usePageTurning } from "./use-page-turning.ts";

function Turned({ name, onTurn }: { readonly name: string; readonly onTurn: (by: number, name: string) => void }) {
  const page = useRef<HTMLElement>(null);
  usePageTurning(page, (by) => onTurn(by, name));
  return <main ref={page}>{name}</main>;
}

const touch = (clientX: number) => ({
  touches: [{ clientX, clientY: 300 }],
  changedTouches: [{ clientX, clientY: 303 }],
});

test("a page rendered again during a swipe still turns, and uses its newest content", () => {
  const turns: [number, string][] = [];
  const onTurn = (by: number, name: string) => void turns.push([by, name]);
  const { rerender } = render(<Turned name="before" onTurn={onTurn} />);
  const main = screen.getByRole("main");
  fireEvent.touchStart(main, touch(300));
  act(() => rerender(<Turned name="after" onTurn={onTurn} />));
  fireEvent.touchEnd(main, touch(120));
  fireEvent.keyDown(main, { key: "ArrowLeft" });
  expect(turns).toEqual([
    [1, "after"],
    [-1, "after"],
  ]);
});
