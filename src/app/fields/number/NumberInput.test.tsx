import { cleanup, render, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { useState } from "react";
import { afterEach, beforeEach, expect, test } from "vitest";
import { changeSettings } from "../../base/settings/settings.ts";
import { NumberInput, type NumberInputProps } from "./NumberInput.tsx";

beforeEach(() => changeSettings({ language: "en" }));
afterEach(cleanup);

/** A field, and a button that takes the focus from it. */
function Field({ start = "", ...props }: Partial<NumberInputProps> & { readonly start?: string }) {
  const [text, setText] = useState(start);
  return (
    <>
      <NumberInput {...props} text={text} onText={setText} />
      <button type="button">out</button>
    </>
  );
}
const input = () => screen.getByRole<HTMLInputElement>("textbox");
async function typed(
  keys: string,
  props: Partial<NumberInputProps> & { readonly start?: string } = {},
): Promise<string> {
  render(<Field selects {...props} />);
  input().focus();
  await userEvent.keyboard(keys);
  return input().value;
}

test.each([
  ["12-", "-12"],
  ["60-2", "60-2"],
  ["2+3-", "2+3-"],
  ["-{Backspace}7", "7"],
])("%s makes %s", async (keys, shown) => expect(await typed(keys)).toBe(shown));

test("a minus on a selected number begins a negative one", async () => {
  expect(await typed("-", { start: "5" })).toBe("-5");
  await userEvent.keyboard("7");
  expect(input().value).toBe("-7");
});

test("a minus is over when the field shows another value", async () => {
  const { rerender } = render(<Field start="-5" of="a" selects />);
  input().focus();
  await userEvent.keyboard("-");
  rerender(<Field start="-5" of="b" selects />);
  input().select();
  await userEvent.keyboard("7");
  expect(input().value).toBe("7");
});

test("a sum is evaluated when the field is left, unless the field does that itself", async () => {
  await typed("1.5*2");
  await userEvent.click(screen.getByRole("button"));
  expect(input().value).toBe("3");
  cleanup();
  await typed("1.5*2", { sums: false });
  await userEvent.click(screen.getByRole("button"));
  expect(input().value).toBe("1.5*2");
});

test("the decimal sign is that of the screen, and literal text stays as typed", async () => {
  changeSettings({ language: "de" });
  expect(await typed("{Shift}", { start: "1.5" })).toBe("1,5");
  cleanup();
  expect(await typed("1.5-", { kind: "typed" })).toBe("1.5-");
});

test("the keypad is that of a number, and none where nothing but text is typed", async () => {
  await typed("{Shift}");
  expect(input().dataset["number"]).toBe("words");
  cleanup();
  await typed("{Shift}", { keypad: "open" });
  expect(input().dataset["number"]).toBe("open");
  cleanup();
  await typed("{Shift}", { kind: "text" });
  expect(input().dataset["number"]).toBe(undefined);
});

test("key handlers of the owner come first, and without the sign key a minus is typed", async () => {
  expect(await typed("1-", { onKeyDown: (event) => event.key === "-" && event.preventDefault() })).toBe("1");
  cleanup();
  expect(await typed("1-", { signed: false })).toBe("1-");
});
