import { METRIC_SIZES } from "../../kernel/contour/metric-thread.ts";
import { CENTRE_FORMS, type CentreForm } from "../../kernel/plan/tool.ts";
import type { NamedThread } from "../../kernel/thread/named-thread.ts";
import { tapRows } from "./tap-of-thread.ts";
import { freeNumber, type ToolList } from "./tool-list.ts";
import type { ToolEntry } from "./tool-entry.ts";

type Cells = ToolEntry["cells"];

/** Point angle of a usual drill, degrees. */
const POINT = "118";
/**
 * Drills by diameter with the flute length of DIN 338, above ⌀20 of DIN 345, recalled (tag K), mm: core holes of the taps,
 * holes that the usual bars enter, and the largest for the shipped boring bars.
 */
const drill = (NAME: string, R: string, LCUTS: string): Cells => ({ NAME, TYPE: "DRILL", R, "T-ANGLE": POINT, LCUTS });
/** Taps of metric coarse threads; the length of their thread is recalled of DIN 371 and DIN 376 (tag K), mm. */
const tap = (nominal: number, LCUTS: string): Cells => ({
  NAME: `TAP-M${nominal}`,
  TYPE: "TAP",
  R: String(nominal / 2),
  PITCH: String(METRIC_SIZES.find(([d]) => d === nominal)?.[1] ?? ""),
  LCUTS,
});

/**
 * Body and pilot of the centre drills of a size, mm: A and R, then B. Recalled of ISO 866 and ISO 2540 (tag K): LCUTS is
 * the length of the pilot, which decides how deep the hole gets, and is measured on the drill.
 */
const CENTRES: readonly (readonly [d1: number, body: number, bodyB: number, pilot: number])[] = [
  [1, 3.15, 4, 1.3],
  [1.6, 4, 6.3, 2],
  [2, 5, 8, 2.5],
  [2.5, 6.3, 10, 3.1],
  [3.15, 8, 11.2, 3.9],
  [4, 10, 14, 5],
  [6.3, 16, 20, 8],
  [10, 25, 31.5, 12.8],
];
/** Angle of the cone, degrees. */
const CONE = "60";
const centre = (form: CentreForm, d1: number, body: number, pilot: number): Cells => ({
  NAME: `CENTER-${form}${d1}`,
  TYPE: "CENTER",
  R: String(body / 2),
  "T-ANGLE": CONE,
  // The pilot of R is not known: the shortest of the standard is taken.
  ...(form !== "R" && { LCUTS: String(pilot) }),
});

const ROWS: readonly Cells[] = [
  drill("DRILL-D5", "2.5", "52"),
  drill("DRILL-D6.8", "3.4", "69"),
  drill("DRILL-D8.5", "4.25", "75"),
  drill("DRILL-D10.2", "5.1", "87"),
  drill("DRILL-D12", "6", "101"),
  drill("DRILL-D16", "8", "120"),
  drill("DRILL-D20", "10", "140"),
  drill("DRILL-D26", "13", "165"),
  tap(6, "15"),
  tap(8, "18"),
  tap(10, "20"),
  tap(12, "24"),
  ...CENTRE_FORMS.flatMap((form) =>
    CENTRES.map(([d1, body, bodyB, pilot]) => centre(form, d1, form === "B" ? bodyB : body, pilot)),
  ),
  // Behind the others, so that these keep their numbers.
  drill("DRILL-D2.5", "1.25", "30"),
  drill("DRILL-D3.3", "1.65", "36"),
  drill("DRILL-D4.2", "2.1", "43"),
  drill("DRILL-D7.8", "3.9", "75"),
  drill("DRILL-D9", "4.5", "81"),
  drill("DRILL-D11", "5.5", "94"),
  drill("DRILL-D14", "7", "108"),
  drill("DRILL-D17.5", "8.75", "130"),
  drill("DRILL-D18", "9", "130"),
  drill("DRILL-D22", "11", "150"),
  tap(3, "9"),
  tap(4, "12"),
  tap(5, "13"),
  tap(16, "26"),
  tap(20, "32"),
];
/** Their numbers follow this one. */
const BEHIND = 30;

/** Usual drills, taps and centre drills as rows of a table, and those of a thread, each with a free number. */
export function standardDrills(list: ToolList, thread: NamedThread | null = null): readonly Cells[] {
  let last = BEHIND;
  const ofThread = (thread ? tapRows(thread) : []).filter((row) => !ROWS.some(({ NAME }) => NAME === row.NAME));
  return [...ROWS, ...ofThread].map((cells) => ({
    T: String((last = freeNumber(list, last))),
    ...cells,
  }));
}
