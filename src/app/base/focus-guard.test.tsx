import { cleanup, render, screen, waitFor } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { useState, type ReactNode } from "react";
import { afterEach, beforeAll, expect, test, vi } from "vitest";
import { FIRST_FOCUS, focusPart, guardFocus } from "./focus-guard.ts";

beforeAll(() => guardFocus());
afterEach(cleanup);

const button = (name: string) => screen.getByRole("button", { name });
const focused = () => (document.activeElement === document.body ? "" : document.activeElement?.textContent);

/** Content that changes when a button in it is pressed. */
function Changing({ before, after }: { readonly before: (go: () => void) => ReactNode; readonly after: ReactNode }) {
  const [done, go] = useState(false);
  return <main>{done ? after : before(() => go(true))}</main>;
}

test.each<[string, (go: () => void) => ReactNode, ReactNode, string]>([
  [
    "replaced content: the first control in it",
    (go) => (
      <section key="a">
        <button onClick={go}>Go</button>
      </section>
    ),
    <section key="b">
      <button>First</button>
      <button>Second</button>
    </section>,
    "First",
  ],
  [
    "replaced content with a marked part: the first control of that part",
    (go) => (
      <section key="a">
        <button onClick={go}>Go</button>
      </section>
    ),
    <section key="b">
      <button>Back</button>
      <div {...{ [FIRST_FOCUS]: "" }}>
        <button>Add</button>
      </div>
    </section>,
    "Add",
  ],
  [
    "content that was rendered again: the same control",
    (go) => (
      <section key="a">
        <button>First</button>
        <button onClick={go}>Go</button>
      </section>
    ),
    <section key="b">
      <button>First</button>
      <button>Go</button>
    </section>,
    "Go",
  ],
  [
    "a row that was removed: the next row",
    (go) => (
      <ul>
        <li key="1">
          <button>1</button>
        </li>
        <li key="2">
          <button onClick={go}>Go</button>
        </li>
        <li key="3">
          <button>3</button>
        </li>
      </ul>
    ),
    <ul>
      <li key="1">
        <button>1</button>
      </li>
      <li key="3">
        <button>3</button>
      </li>
    </ul>,
    "3",
  ],
  [
    "a button that disables itself: its neighbour",
    (go) => (
      <p>
        <button>Before</button>
        <button onClick={go}>Go</button>
        <button>After</button>
      </p>
    ),
    <p>
      <button>Before</button>
      <button disabled>Go</button>
      <button>After</button>
    </p>,
    "After",
  ],
])("%s", async (_, before, after, expected) => {
  render(<Changing before={before} after={after} />);
  await userEvent.setup().click(button("Go"));
  await waitFor(() => expect(focused()).toBe(expected));
});

test("what was opened from a dialog that closes leaves the focus where the dialog was opened", async () => {
  function Page() {
    const [open, show] = useState(false);
    return (
      <main>
        <button>First</button>
        {/* The opener is rendered again with the dialog. */}
        <button key={String(open)} onClick={() => show(true)}>
          Open
        </button>
        {open && (
          <dialog open>
            <button onClick={() => show(false)}>Done</button>
          </dialog>
        )}
      </main>
    );
  }
  render(<Page />);
  const user = userEvent.setup();
  await user.click(button("Open"));
  button("Done").focus();
  await user.keyboard("{Enter}");
  await waitFor(() => expect(focused()).toBe("Open"));
});

test("a part of the page gets the focus when it appears, unless the user moves it first", async () => {
  const asked = vi.fn();
  const { rerender } = render(<button>Other</button>);
  focusPart(".part", asked);
  rerender(
    <div className="part">
      <button>Part</button>
    </div>,
  );
  await waitFor(() => expect(focused()).toBe("Part"));
  expect(asked).toHaveBeenCalledTimes(1);
});

test("a click beside every control takes the focus away", async () => {
  render(
    <main>
      <button>Go</button>
      <p>Text</p>
    </main>,
  );
  const user = userEvent.setup();
  await user.click(button("Go"));
  await user.click(screen.getByText("Text"));
  await new Promise((done) => setTimeout(done, 100));
  expect(document.activeElement).toBe(document.body);
});
