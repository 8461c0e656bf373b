import { expect, test } from "vitest";
import { parse } from "./parse.ts";
import { styleAt } from "./read-style.ts";

test("names and titles do not affect the number style: M48X2 is no X without a sign", () => {
  const text = "0 BEGIN PGM NUT_M48X2 MM\n1 * - BORE X30\n2 ; THREAD M48X2\n3 L X+38 Z-2\n4 END PGM NUT_M48X2 MM\n";
  expect(styleAt(parse(text), 0).plus).toBe(true);
  expect(styleAt(parse(text.replace("X+38", "X38")), 0).plus).toBe(false);
});
