import { METRIC_SIZES } from "../../kernel/contour/metric-thread.ts";
import { freeNumber, type ToolList } from "./tool-list.ts";
import type { ToolEntry } from "./tool-entry.ts";

type Cells = ToolEntry["cells"];

/** Point angle of a usual drill, degrees. */
const POINT = "118";
/** Drills by diameter with the flute length of DIN 338, mm; the smaller ones are the core holes of the taps. */
const drill = (NAME: string, R: string, LCUTS: string): Cells => ({ NAME, TYPE: "DRILL", R, "T-ANGLE": POINT, LCUTS });
/** Taps of metric coarse threads. */
const tap = (nominal: number, LCUTS: string): Cells => ({
  NAME: `TAP-M${nominal}`,
  TYPE: "TAP",
  R: String(nominal / 2),
  PITCH: String(METRIC_SIZES.find(([d]) => d === nominal)?.[1] ?? ""),
  LCUTS,
});

const ROWS: readonly Cells[] = [
  drill("DRILL-D5", "2.5", "52"),
  drill("DRILL-D6.8", "3.4", "69"),
  drill("DRILL-D8.5", "4.25", "75"),
  drill("DRILL-D10.2", "5.1", "87"),
  drill("DRILL-D12", "6", "101"),
  drill("DRILL-D16", "8", "120"),
  drill("DRILL-D20", "10", "140"),
  tap(6, "15"),
  tap(8, "18"),
  tap(10, "20"),
  tap(12, "24"),
];
/** Their numbers follow this one. */
const BEHIND = 30;

/** Usual drills and taps as rows of a table, each with a free number. */
export function standardDrills(list: ToolList): readonly Cells[] {
  let last = BEHIND;
  return ROWS.map((cells) => ({ T: String((last = freeNumber(list, last))), ...cells }));
}
