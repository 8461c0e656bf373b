import { cleanup, fireEvent, render, screen, waitFor } from "@testing-library/react";
import { useState } from "react";
import { afterEach, beforeAll, expect, test } from "vitest";
import { fetchTexts } from "../../base/settings/loaded-texts.ts";
import { enterField, fieldEntry, scopeOf, stepField, writeEntry } from "./field-typing.ts";
import { NumberKeys } from "./NumberKeys.tsx";

beforeAll(() => fetchTexts("en"));
afterEach(cleanup);

function Fields({ start = ["12.5", "-7"] }: { readonly start?: readonly string[] }) {
  const [texts, setTexts] = useState(start);
  return (
    <>
      {texts.map((text, i) => (
        <input
          key={i}
          aria-label={`field ${i + 1}`}
          data-number={i === 1 ? "open" : "words"}
          value={text}
          onChange={(e) => setTexts(texts.with(i, e.currentTarget.value))}
        />
      ))}
      <input aria-label="name" defaultValue="SHAFT" />
      <NumberKeys />
    </>
  );
}
const field = (name: string) => screen.getByRole<HTMLInputElement>("textbox", { name });
/** Taps a field: pointer press, then focus. */
function touch(input: HTMLElement, pointerType = "touch") {
  fireEvent.pointerDown(input, { pointerType });
  input.focus();
}
const key = (name: string) => fireEvent.click(screen.getByRole("button", { name }));
const keypad = () => screen.queryByRole("group", { name: "Keypad" });

test("tapping a number field opens the keypad instead of the device keyboard; a name field keeps that", async () => {
  render(<Fields />);
  touch(field("field 1"));
  expect(await screen.findByRole("group", { name: "Keypad" })).toBeTruthy();
  expect(field("field 1").inputMode).toBe("none");
  touch(field("name"));
  await waitFor(() => expect(keypad()).toBeNull());
  expect(field("name").inputMode).toBe("");
});

test("tapping something else hits it in place: the keypad closes a frame later", async () => {
  render(<Fields />);
  touch(field("field 1"));
  await screen.findByRole("group", { name: "Keypad" });
  touch(field("name"));
  await Promise.resolve();
  expect(keypad()).not.toBeNull();
  await waitFor(() => expect(keypad()).toBeNull());
});

test("a mouse does not open it", async () => {
  render(<Fields />);
  touch(field("field 1"), "mouse");
  await new Promise((done) => requestAnimationFrame(done));
  expect(keypad()).toBeNull();
});

test("digits replace the selection, the sign changes anywhere, a sum can be typed", async () => {
  render(<Fields />);
  touch(field("field 1"));
  fireEvent.click(field("field 1"));
  await screen.findByRole("group", { name: "Keypad" });
  for (const name of ["4", "8", "Decimal point", "5"]) key(name);
  expect(field("field 1").value).toBe("48.5");
  key("Change the sign");
  expect(field("field 1").value).toBe("-48.5");
  for (const name of ["Erase one character", "7", "Divided by", "2"]) key(name);
  expect(field("field 1").value).toBe("-48.7/2");
  expect(document.activeElement).toBe(field("field 1"));
});

test("a field that is focused after the tap: the first digit replaces the text, and none is lost", async () => {
  render(<Fields />);
  touch(field("field 1"));
  await screen.findByRole("group", { name: "Keypad" });
  for (const name of ["4", "8", "Decimal point", "5"]) key(name);
  expect(field("field 1").value).toBe("48.5");
});

test("ENT goes to the next number field and closes the keypad after the last one; a question mark leaves a value open", async () => {
  render(<Fields />);
  touch(field("field 1"));
  await screen.findByRole("group", { name: "Keypad" });
  expect(screen.queryByRole("button", { name: "Question mark: not given" })).toBeNull();
  key("ENT: accept the value, next field");
  expect(document.activeElement).toBe(field("field 2"));
  key("Question mark: not given");
  expect(field("field 2").value).toBe("?");
  key("Previous field");
  expect(document.activeElement).toBe(field("field 1"));
  key("Next field");
  key("ENT: accept the value, next field");
  await waitFor(() => expect(keypad()).toBeNull());
});

test("letters: the device keyboard opens for this field, until it is left", async () => {
  render(<Fields />);
  touch(field("field 1"));
  await screen.findByRole("group", { name: "Keypad" });
  key("Letters: device keyboard");
  await waitFor(() => expect(keypad()).toBeNull());
  expect(document.activeElement).toBe(field("field 1"));
  expect(field("field 1").inputMode).toBe("text");
  touch(field("field 2"));
  await screen.findByRole("group", { name: "Keypad" });
  await waitFor(() => expect(field("field 1").inputMode).toBe("none"));
});

test("typing fires the field's events, the caret stays behind the text, and the field's own Enter action goes first", () => {
  let entered = 0;
  function One() {
    const [text, setText] = useState("3,75");
    return (
      <dialog open>
        <input
          aria-label="one"
          data-number="words"
          value={text}
          onChange={(e) => setText(e.currentTarget.value)}
          onKeyDown={(e) => {
            if (e.key !== "Enter") return;
            e.preventDefault();
            entered += 1;
          }}
        />
      </dialog>
    );
  }
  render(<One />);
  const input = field("one");
  input.focus();
  input.setSelectionRange(1, 1);
  writeEntry(input, { ...fieldEntry(input), text: "36,75", from: 2, to: 2 });
  expect([input.value, input.selectionStart, input.selectionEnd]).toEqual(["36,75", 2, 2]);
  enterField(input);
  expect([entered, document.activeElement]).toEqual([1, input]);
  expect(stepField(input, 1)).toBe(false);
  expect(scopeOf(input).localName).toBe("dialog");
});
