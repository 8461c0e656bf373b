import { render } from "@testing-library/react";
import { expect, test } from "vitest";
import { Unbroken } from "./Unbroken.tsx";

test.each([
  ["0.4 mm² left", "0.4_mm² left"],
  ["at 180 m/min, 0,2 mm/tr", "at 180_m/min, 0,2_mm/tr"],
  ["4 mmol and 3 so", "4 mmol and 3 so"],
  ["Pourquoi ? « Oui » : 5 %", "Pourquoi_? «_Oui_»_: 5_%"],
  ["Rz ≈ f² / 8r, r = 0.4", "Rz_≈ f² / 8r, r_=_0.4"],
])("%s", (text, shown) => {
  const { container } = render(<Unbroken text={text} />);
  expect(container.textContent.replaceAll("\u00a0", "_")).toBe(shown);
});

test("a negative number is one piece", () => {
  const { container } = render(<Unbroken text="from Z-38 to Z+2" />);
  expect([...container.querySelectorAll(".unbroken")].map(({ textContent }) => textContent)).toEqual(["Z-38"]);
});
