import { fireEvent, render, screen } from "@testing-library/react";
import { expect, test } from "vitest";
import { LongList } from "./LongList.tsx";

const all = Array.from({ length: 1000 }, (_, i) => i);
const list = (around: number) => (
  <LongList
    all={all}
    around={around}
    more={(n) => `${n} more`}
    earlier={(n) => `${n} earlier`}
    row={(i) => (
      <li key={i}>
        <button type="button">{`row ${i}`}</button>
      </li>
    )}
  />
);
const rows = () => {
  const shown = screen.getAllByText(/^row /);
  return [shown[0], shown.at(-1)].map((row) => Number(row?.textContent?.slice(4)));
};
const press = (name: string) => fireEvent.click(screen.getByText(name));

test("a long list shows the rows around one, and buttons show those beside with the focus on the nearest", () => {
  const { rerender } = render(list(437));
  expect(rows()).toEqual([400, 599]);
  press("200 earlier");
  expect(rows()).toEqual([200, 599]);
  expect(document.activeElement?.textContent).toBe("row 399");
  press("200 more");
  expect(rows()).toEqual([200, 799]);
  expect(document.activeElement?.textContent).toBe("row 600");
  rerender(list(250));
  expect(rows()).toEqual([200, 799]);
  rerender(list(999));
  expect(rows()).toEqual([800, 999]);
  expect(screen.queryByText(/more/)).toBeNull();
});
