import { cleanup, render, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { useState } from "react";
import { afterEach, beforeEach, expect, test } from "vitest";
import { changeLanguage } from "../../../app/base/settings/settings.ts";
import { anyNumber } from "../../../program/values/field.ts";
import { AskedNumber } from "./AskedNumber.tsx";

function Asked() {
  const [text, setText] = useState("");
  return <AskedNumber name="Z" unit="mm" field={{ ...anyNumber, optional: false }} text={text} onText={setText} />;
}

beforeEach(() => changeLanguage("en"));
afterEach(cleanup);

test.each(["-", "+"])("only %s is not called wrong before the field is left, but stays open", async (sign) => {
  const user = userEvent.setup();
  render(<Asked />);
  const input = screen.getByRole("textbox");
  const said = () => [
    input.getAttribute("aria-invalid"),
    screen.queryByRole("status") !== null,
    input.getAttribute("data-open"),
  ];
  await user.type(input, sign);
  expect(said()).toEqual(["false", false, "true"]);
  await user.type(input, "x");
  expect(said()).toEqual(["true", true, "true"]);
  await user.keyboard("{Backspace}{Tab}");
  expect(said()).toEqual(["true", true, "true"]);
});
