import { act, cleanup, fireEvent, render, screen } from "@testing-library/react";
import { memo, startTransition, useLayoutEffect, useState } from "react";
import { flushSync } from "react-dom";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import {
  deferWhileTyping,
  renderDeferred,
  createDeferredStore,
  DeferredUntilPaint,
  useTyping,
  whileTyping,
} from "./typing.ts";

interface Held {
  readonly text: string;
  readonly other: number;
}

const useResult = createDeferredStore(() => ({ of: "12.5", other: "3" }), "result");
const useHeld = createDeferredStore<Held>(() => ({ text: "12.5", other: 3 }));
const Later = () => <output aria-label="later">{useHeld((s) => s.text)}</output>;
const AtOnce = () => <output aria-label="at once">{useHeld.atOnce((s) => s.text)}</output>;
const Result = () => <output aria-label="result">{useResult((s) => s.of)}</output>;
const shown = (name: string) => screen.getByLabelText(name).textContent;

const type = (text: string) => act(() => whileTyping(() => useHeld.setState({ text })));

beforeEach(() => {
  useHeld.setState({ text: "12.5", other: 3 });
  useResult.setState({ of: "12.5", other: "3" });
  render(
    <>
      <Later />
      <Result />
      <AtOnce />
      <input aria-label="field" />
      <button type="button">elsewhere</button>
    </>,
  );
});
afterEach(cleanup);

test("the typed value is drawn first, and everything else updates after that frame is painted", async () => {
  type("12.57");
  expect([useHeld.getState().text, shown("at once"), shown("later")]).toEqual(["12.57", "12.57", "12.5"]);
  await expect.poll(() => shown("later")).toBe("12.57");
});

test("updates come once, with the value typed last", async () => {
  type("12.57");
  type("12.571");
  expect(shown("later")).toBe("12.5");
  await expect.poll(() => shown("later")).toBe("12.571");
});

test("any other change flushes the pending updates with it", () => {
  type("12.57");
  act(() => useHeld.setState({ other: 4 }));
  expect(shown("later")).toBe("12.57");
});

test.each<[string, () => unknown]>([
  ["Enter", () => fireEvent.keyDown(screen.getByLabelText("field"), { key: "Enter" })],
  ["a shortcut", () => fireEvent.keyDown(screen.getByLabelText("field"), { key: "z", ctrlKey: true })],
  ["a digit elsewhere", () => fireEvent.keyDown(screen.getByRole("button"), { key: "7" })],
  ["a finger", () => fireEvent.pointerDown(screen.getByRole("button"))],
  ["the loss of the keyboard", () => fireEvent.focusOut(screen.getByLabelText("field"))],
])("%s finds all updates flushed", (_, acts) => {
  let found: string | null = null;
  const look = () => (found = shown("later"));
  for (const event of ["keydown", "pointerdown", "focusout"]) document.body.addEventListener(event, look);
  type("12.57");
  acts();
  for (const event of ["keydown", "pointerdown", "focusout"]) document.body.removeEventListener(event, look);
  expect(found).toBe("12.57");
});

test("work, text and result update one after the other", async () => {
  const said: string[] = [];
  const note = (name: string) => said.push(`${name}: ${[shown("later"), shown("result")].join(" ")}`);
  act(() =>
    whileTyping(() => {
      useResult.setState({ of: "12.57" });
      deferWhileTyping(() => note("text"));
      useHeld.setState({ text: "12.57" });
    }),
  );
  note("drawn");
  await expect.poll(() => shown("result")).toBe("12.57");
  expect(said).toEqual(["drawn: 12.5 12.5", "text: 12.57 12.5"]);
});

test("a result that arrives meanwhile is queued, and an action finds it flushed", () => {
  type("12.57");
  act(() => useResult.setState({ of: "12.57" }));
  expect([shown("later"), shown("result")]).toEqual(["12.5", "12.5"]);
  fireEvent.keyDown(screen.getByLabelText("field"), { key: "Enter" });
  expect([shown("later"), shown("result")]).toEqual(["12.57", "12.57"]);
});

test("an action during a deferred render finds the result rendered", () => {
  renderDeferred(() => useResult.setState({ of: "12.571" }));
  expect(shown("result")).toBe("12.5");
  fireEvent.pointerDown(screen.getByRole("button"));
  expect(shown("result")).toBe("12.571");
});

test("a key that continues the number flushes nothing", () => {
  type("12.57");
  fireEvent.keyDown(screen.getByLabelText("field"), { key: "3" });
  fireEvent.keyDown(screen.getByLabelText("field"), { key: "Backspace" });
  expect(shown("later")).toBe("12.5");
});

test("a field without pending updates shows the text that its owner makes", () => {
  const Owned = () => {
    const [said, say] = useState("7.25");
    const [text, typeOn] = useTyping("of it", said, (next) => say(next.replace("x", "")));
    return <input aria-label="owned" value={text} onChange={(event) => typeOn(event.currentTarget.value)} />;
  };
  render(<Owned />);
  fireEvent.change(screen.getByLabelText("owned"), { target: { value: "7.2x" } });
  expect(screen.getByLabelText<HTMLInputElement>("owned").value).toBe("7.2");
});

test("a field shows the typed text until the flush, and then that of the work", async () => {
  const Held = () => {
    const [text, typeOn] = useTyping(
      "of it",
      useHeld((s) => s.text),
      (next) => useHeld.setState({ text: next.trim() }),
    );
    return <input aria-label="held" value={text} onChange={(event) => typeOn(event.currentTarget.value)} />;
  };
  render(<Held />);
  const value = () => screen.getByLabelText<HTMLInputElement>("held").value;
  fireEvent.change(screen.getByLabelText("held"), { target: { value: "12.57 " } });
  expect([value(), shown("later")]).toEqual(["12.57 ", "12.5"]);
  await expect.poll(value).toBe("12.57");
});

const renders = vi.fn();
const Of = memo(function Of({ of }: { readonly of: "of" | "other" }) {
  renders();
  return <output aria-label="followed">{useResult((s) => s[of])}</output>;
});

test("a component follows what it selects of a result, and does not render otherwise", () => {
  const { rerender } = render(<Of of="of" />);
  renders.mockClear();
  act(() => useResult.setState({ other: "7" }));
  expect(shown("followed")).toBe("12.5");
  expect(renders).not.toHaveBeenCalled();
  rerender(<Of of="other" />);
  expect(shown("followed")).toBe("7");
});

test("a change of a result before a component subscribes is shown", () => {
  const Early = () => {
    useLayoutEffect(() => useResult.setState({ of: "3.25" }), []);
    return <Of of="of" />;
  };
  render(<Early />);
  expect(shown("followed")).toBe("3.25");
});

test("the last change of a transition counts, also if it equals the shown value", async () => {
  render(<Of of="of" />);
  startTransition(() => useResult.setState({ of: "4.75" }));
  expect(shown("followed")).toBe("12.5");
  startTransition(() => useResult.setState({ of: "12.5" }));
  startTransition(() => useResult.setState({ other: "9" }));
  await act(async () => new Promise((done) => setTimeout(done)));
  expect(shown("followed")).toBe("12.5");
});

test("a deferred part shows the previous state while a key is drawn", async () => {
  const seen: string[] = [];
  const Shows = ({ text }: { readonly text: string }) => void seen.push(text);
  const { rerender } = render(
    <DeferredUntilPaint>
      <Shows text="12.5" />
    </DeferredUntilPaint>,
  );
  flushSync(() =>
    rerender(
      <DeferredUntilPaint>
        <Shows text="12.57" />
      </DeferredUntilPaint>,
    ),
  );
  expect(seen).toEqual(["12.5"]);
  await expect.poll(() => seen.at(-1)).toBe("12.57");
});
