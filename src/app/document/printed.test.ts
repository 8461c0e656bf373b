import { expect, test } from "vitest";
import { cuttingCycles } from "../../cycles/index.ts";
import { exampleJob } from "../../program/job/job.ts";
import { shippedList } from "../../program/tools/tool-list.ts";
import { blockCount, openText, printedBlocks, textOf } from "./printed.ts";
import { openFirstWork } from "./store.ts";

const numbersOf = (text: string) => printedBlocks(text).map(({ number, lines }) => [number, lines.length]);

test.each<[string, string, readonly (readonly [number, number])[]]>([
  [
    "a file with numbers",
    "0 BEGIN PGM A MM\n1 CYCL DEF 811 X ~\nQ215=+0 ;A ~\nQ460=+2\n2 CYCL CALL\n",
    [
      [0, 1],
      [1, 3],
      [2, 1],
    ],
  ],
  [
    "a file without numbers, CR LF",
    "BEGIN PGM A MM\r\nCYCL DEF 811 X ~\r\nQ215=+0 ~\r\nQ460=+2\r\nCYCL CALL\r\n",
    [
      [0, 1],
      [1, 3],
      [2, 1],
    ],
  ],
  [
    "the look of the manual",
    "7 CYCL DEF 811  X\nQ215=+0 ;A\nQ460=+2\n8 L  X+3\n",
    [
      [7, 3],
      [8, 1],
    ],
  ],
  [
    "DIN/ISO",
    "%A G71 *\nN1 T5 *\n/N3 G811 Q215=+0 Q460=+2 *\nN99999999 %A G71 *\n",
    [
      [0, 1],
      [1, 1],
      [3, 1],
      [99999999, 1],
    ],
  ],
])("%s is split into blocks", (_, text, blocks) => {
  expect(numbersOf(text)).toEqual(blocks);
  expect(blockCount(text)).toBe(blocks.length);
});

test("a job is printed with its own tools or those of the device, whatever work is open", () => {
  const [cycle] = cuttingCycles;
  if (!cycle) throw new Error("the catalogue is empty");
  const kept = { ...exampleJob(cycle), tool: null };
  openFirstWork(null, null);
  const text = textOf(kept);
  openFirstWork({ ...kept, tools: shippedList.slice(5, 6) }, "other");
  expect(textOf(kept)).toBe(text);
  expect(openText()).not.toBe(text);
});
