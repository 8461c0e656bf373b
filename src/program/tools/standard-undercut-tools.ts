import type { ToolEntry } from "./tool-entry.ts";
import { freeNumber, type ToolList } from "./tool-list.ts";

type Cells = ToolEntry["cells"];

/**
 * Finishing tools for undercuts: an insert of 35° at 107.5° leaves the face and descends on the cylinder, which DIN 509
 * needs at form F (8° and 15°). Tip orientation 1 outside, 7 inside; the small nose is for the small radii.
 */
const tool = (NAME: string, TO: string, RS: string, CUTLENGTH: string): Cells => ({
  NAME,
  TYPE: "FINISH",
  TO,
  RS,
  "T-ANGLE": "107.5",
  "P-ANGLE": "35",
  CUTLENGTH,
});
const ROWS: readonly Cells[] = [
  tool("UNDERCUT-V35-R04", "1", "0.4", "16"),
  tool("UNDERCUT-V35-R02", "1", "0.2", "16"),
  tool("BORE-UNDERCUT-V35-R04", "7", "0.4", "11"),
  tool("BORE-UNDERCUT-V35-R02", "7", "0.2", "11"),
];
/** Their numbers follow this one. */
const BEHIND = 15;

/** Tools that reach undercuts as rows of a table, each with a free number. */
export function standardUndercutTools(list: ToolList): readonly Cells[] {
  let last = BEHIND;
  return ROWS.map((cells) => ({ T: String((last = freeNumber(list, last))), ...cells }));
}
