import { expect, test } from "vitest";
import { lengthsIn } from "./lengths.ts";

test("an inch program shows lengths, areas and units in inches, with one more decimal", () => {
  const { number, fixed, position, signed, area, fixedArea, words } = lengthsIn("de", "inch", 25.4);
  expect([number(37.465), number(0.3), fixed(0.178, 3), position(-95.0011), signed(52)]).toEqual([
    "1,475",
    "0,0118",
    "0,0070",
    "-3,7402",
    "+2,0472",
  ]);
  expect([area(0.45, 2), fixedArea(0.45, 3)]).toEqual(["0,0007", "0,000698"]);
  expect([words("mm/U"), words("0,1 mm²"), words("f 1 mm, r 2 mm"), words("4 µm"), words("Kommt bis 3 m/min")]).toEqual(
    ["inch/U", "0,1 inch²", "f 1 inch, r 2 inch", "4 µin", "Kommt bis 3 m/min"],
  );
});

test("a program in mm shows values unchanged", () => {
  const { number, fixed, position, area, words } = lengthsIn("en", "mm", 1);
  expect([number(37.465), fixed(0.178, 2), position(-95.0011), area(0.456, 2), words("mm/rev")]).toEqual([
    "37.465",
    "0.18",
    "-95.001",
    "0.46",
    "mm/rev",
  ]);
});

test("a volume is in cm³, in an inch program in cubic inches", () => {
  expect([lengthsIn("en", "mm", 1).volume(16.387064), lengthsIn("en", "inch", 25.4).volume(16.387064)]).toEqual([
    "16.39\u00a0cm³",
    "1\u00a0inch³",
  ]);
});
