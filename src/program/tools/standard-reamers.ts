import { toleranceMiddle } from "../../kernel/fit/typed-tolerance.ts";
import { radiusOf } from "../../kernel/units.ts";
import { freeNumber, type ToolList } from "./tool-list.ts";
import type { ToolEntry } from "./tool-entry.ts";

type Cells = ToolEntry["cells"];

/** Point angle of a usual drill, degrees. */
const POINT = "118";

/**
 * Machine reamers H7 of DIN 212-2 (ISO 521) of high-speed steel with the length of their flutes, and the drills before them
 * with theirs of DIN 338 (recalled, tag K), mm. Where no drill is named, a usual one is there.
 */
const SIZES: readonly (readonly [d: number, flutes: number, drill?: number, length?: number])[] = [
  [3, 15, 2.8, 33],
  [4, 19, 3.8, 43],
  [5, 23, 4.8, 52],
  [6, 26, 5.8, 57],
  [8, 33],
  [10, 38, 9.8, 87],
  [12, 44, 11.8, 94],
  [14, 47, 13.75, 108],
  [16, 52, 15.75, 120],
  [18, 56, 17.75, 130],
  [20, 60, 19.75, 140],
];

/** A reamer is ground so that it makes the middle of its class: R is half of that. */
const measured = (d: number): string => radiusOf(toleranceMiddle("H7", d)?.middle ?? d).toFixed(4);

const ROWS: readonly Cells[] = SIZES.flatMap(([d, flutes, drill, length]) => [
  ...(drill === undefined
    ? []
    : [
        {
          NAME: `DRILL-D${drill}`,
          TYPE: "DRILL",
          R: String(radiusOf(drill)),
          "T-ANGLE": POINT,
          LCUTS: String(length),
        } as const,
      ]),
  { NAME: `REAMER-D${d}-H7`, TYPE: "REAM", R: measured(d), LCUTS: String(flutes) },
]);
/** Their numbers follow this one. */
const BEHIND = 300;

/** Usual reamers with the drills before them as rows of a table, each with a free number. */
export function standardReamers(list: ToolList): readonly Cells[] {
  let last = BEHIND;
  return ROWS.map((cells) => ({ T: String((last = freeNumber(list, last))), ...cells }));
}
