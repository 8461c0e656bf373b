import { expect, test } from "vitest";
import plate from "../../../examples/plate.h?raw";
import { parse } from "../../../nc/parse.ts";
import { run } from "../../../program/run/run.ts";
import { shippedTools } from "../../../program/tools/shipped-tools.ts";
import { motionsOf, operationRows, pathPicture } from "./operation-rows.ts";

const shop = { tools: shippedTools, rapid: 10_000 };

test("an operation without a cycle is drawn by its own path", () => {
  const milled = run(parse(plate), shop);
  const pictureOf = (from: number, to: number) => pathPicture(motionsOf(milled)(from, to), milled.cuboid);
  const [square, rounded] = [pictureOf(6, 18), pictureOf(18, 34)];
  expect(square?.milled?.stock).not.toBeNull();
  expect(rounded?.milled?.ways).not.toEqual(square?.milled?.ways);
  expect(pictureOf(0, 6)).toBeNull();
});

test("a path turned block by block has Z to the right and X upwards", () => {
  const turned = run(
    parse(
      "BEGIN PGM T MM\nBLK FORM CYLINDER Z D60 L70 DIST+1\nFUNCTION MODE TURN\nTOOL CALL 3\n" +
        "FUNCTION TURNDATA SPIN VCONST:OFF S700 M3\nM136\nL X+40 Z+2 R0 FMAX\nL Z-20 F0.2\nEND PGM T MM\n",
    ),
    shop,
  );
  expect(pathPicture(motionsOf(turned)(0, 9), null)?.milled).toEqual({
    stock: null,
    ways: [{ d: "M2 -20L-20 -20", wide: 0 }],
  });
});

test.each([
  ["FUNCTION MODE MILL", undefined],
  ["FUNCTION MODE TURN", 1],
])("before the first run, the tool of blocks after %s is number %j of the table of turning tools", (mode, number) => {
  const text = `BEGIN PGM T MM\n* - PLATE\n${mode}\nTOOL CALL 1\nL X+40 Z+2 R0 FMAX\nL Z-20 F0.2\nEND PGM T MM\n`;
  const rows = operationRows(parse(text), { outcome: null, file: null, entries: [], tools: shippedTools });
  expect(rows.map(({ tool, known }) => [tool, known?.T])).toEqual([["1", number]]);
});
