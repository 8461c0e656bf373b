import { cleanup, render, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { useState } from "react";
import { afterEach, expect, test } from "vitest";
import { enterNext } from "./enter-next.ts";
import { LabelledInput } from "./LabelledInput.tsx";

afterEach(cleanup);

/** A field that takes numbers only. */
function Field({ label, start = "" }: { readonly label: string; readonly start?: string }) {
  const [text, setText] = useState(start);
  const wrong = text === "" || Number.isNaN(Number(text));
  return (
    <LabelledInput
      className=""
      label={label}
      text={text}
      onText={setText}
      aria-invalid={wrong}
      messages={wrong && "wrong"}
    />
  );
}
const onEnter = enterNext("button");
const input = (name: string) => screen.getByRole<HTMLInputElement>("textbox", { name });
const wrong = () => screen.queryByText("wrong") !== null;

test("a sign that was just typed is not wrong before the field is left", async () => {
  render(<Field label="X" start="5" />);
  const user = userEvent.setup();
  await user.clear(input("X"));
  expect(wrong()).toBe(true);
  await user.keyboard("-");
  expect([wrong(), input("X").getAttribute("aria-invalid")]).toEqual([false, "false"]);
  await user.keyboard("a");
  expect(wrong()).toBe(true);
  await user.keyboard("{Backspace}{Tab}");
  expect([wrong(), input("X").getAttribute("aria-invalid")]).toEqual([true, "true"]);
});

test("Enter goes to the next field with its text selected, and to what else it stops at", async () => {
  render(
    <div role="form" onKeyDown={onEnter}>
      <Field label="X" />
      <Field label="Z" start="12" />
      <select aria-label="R" />
      <button type="button">Add</button>
    </div>,
  );
  const user = userEvent.setup();
  input("X").focus();
  await user.keyboard("3{Enter}7{Enter}");
  expect(document.activeElement).toBe(screen.getByRole("combobox"));
  await user.keyboard("{Enter}");
  expect([input("X").value, input("Z").value]).toEqual(["3", "7"]);
  expect(document.activeElement).toBe(screen.getByRole("button"));
});
