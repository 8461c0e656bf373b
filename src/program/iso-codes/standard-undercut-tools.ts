import type { ToolEntry } from "../tools/tool-entry.ts";
import { freeNumber, type ToolList } from "../tools/tool-list.ts";
import { fillingOf } from "./code-cells.ts";
import { readToolCodes } from "./tool-code.ts";

type Cells = ToolEntry["cells"];

/**
 * Holder and insert of finishing tools for undercuts: an edge of 35° at 107.5° leaves the face and descends on the
 * cylinder, which DIN 509 needs at form F (8° and 15°); the small nose is for the small radii.
 */
const CODES = [
  "SVHBR 2525 M16 VBMT 160404",
  "SVHBR 2525 M16 VBMT 160402",
  "A20S-SVQBR 11 VBMT 110304",
  "A20S-SVQBR 11 VBMT 110302",
] as const;
/** Their numbers follow this one. */
const BEHIND = 15;

const cellsOf = (code: string): Cells => {
  const { cells } = fillingOf(readToolCodes(code), { id: code, cells: {} });
  const [holder] = code.split(/[ -]/);
  return {
    ...Object.fromEntries(cells.map(({ cell, to }) => [cell, to])),
    NAME: `${code.startsWith("A") ? "BORE-" : ""}${code.split(" ").slice(-2).join("")}-${holder}`,
    TYPE: "FINISH",
  };
};

/** Tools that reach undercuts as rows of a table, each with a free number. */
export function standardUndercutTools(list: ToolList): readonly Cells[] {
  let last = BEHIND;
  return CODES.map((code) => ({ T: String((last = freeNumber(list, last))), ...cellsOf(code) }));
}
