import { diameter, rounded, toRadius } from "../../kernel/units.ts";
import { writeHead } from "../tools/holder-cells.ts";
import type { ToolEntry } from "../tools/tool-entry.ts";
import { freeNumber, type ToolList } from "../tools/tool-list.ts";
import { fillingOf } from "./code-cells.ts";
import { readToolCodes } from "./tool-code.ts";

type Cells = ToolEntry["cells"];
type Corner = readonly [z: number, x: number];

/**
 * Boring bars by their codes with the least bore of ISO 5609 for their diameter, mm (recalled, tag K); thick ones first.
 */
const BORING: readonly (readonly [code: string, leastBore: number, type: "ROUGH" | "FINISH"])[] = [
  ["A25T-SCLCR 12 CCMT 120408", 32, "ROUGH"],
  ["A25T-SDUCR 11 DCMT 11T304", 32, "FINISH"],
  ["A20S-SCLCR 09 CCMT 09T304", 25, "ROUGH"],
  ["A20S-SDUCR 11 DCMT 11T304", 25, "FINISH"],
  ["A16R-SCLCR 09 CCMT 09T304", 20, "ROUGH"],
  ["A16R-SDUCR 07 DCMT 070204", 20, "FINISH"],
  ["A12M-SCLCR 06 CCMT 060204", 16, "ROUGH"],
  ["A12M-SDUCR 07 DCMT 070204", 16, "FINISH"],
  ["A10K-SCLCR 06 CCMT 060204", 13, "ROUGH"],
  ["A10K-SDUCR 07 DCMT 070202", 13, "FINISH"],
  ["A08H-SCLCR 06 CCMT 060202", 11, "ROUGH"],
];

/** A bar along the spindle, mm: its diameter, how far its tip stands out of its side, its length, its least bore. */
interface Bar {
  readonly d: number;
  readonly out: number;
  readonly length: number;
  readonly leastBore: number;
}

const shank = ({ d, out, length, leastBore }: Bar, from: number, head: readonly (readonly Corner[])[]): Cells => ({
  width: String(d),
  length: String(rounded(length - from)),
  offsetZ: String(rounded(from)),
  offsetX: String(-out),
  head: writeHead(head as unknown as Parameters<typeof writeHead>[0]),
  DMIN: String(leastBore),
});

/**
 * Bars of solid carbide with a ground edge for bores that no bar with an insert enters; their sleeve begins at the reach.
 * Sizes as makers of such bars usually have them (recalled, tag K).
 */
const SOLID: readonly (Bar & { readonly reach: number })[] = [
  { d: 7, out: 0.2, leastBore: 8, reach: 40, length: 40 },
  { d: 5.2, out: 0.3, leastBore: 6, reach: 35, length: 35 },
  { d: 3.6, out: 0.2, leastBore: 4.2, reach: 18, length: 18 },
];
/** Diameter of the sleeve of a solid bar, the length of it that matters, and how far the neck begins behind its edge, mm. */
const [SLEEVE, HELD, EDGE] = [16, 40, 1.5];

function solidBar(bar: (typeof SOLID)[number]): Cells {
  const { d, out, reach } = bar;
  // Both have one axis.
  const near = toRadius(diameter(SLEEVE)) - toRadius(diameter(d)) - out;
  const far = near - SLEEVE;
  const sleeve: readonly Corner[] = [
    [reach, near],
    [reach + HELD, near],
    [reach + HELD, far],
    [reach, far],
  ];
  return {
    NAME: `BORE-SOLID-D${bar.leastBore}`,
    TYPE: "FINISH",
    TO: "7",
    RS: "0.2",
    "T-ANGLE": "95",
    "P-ANGLE": "75",
    CUTLENGTH: String(EDGE),
    ...shank(bar, EDGE, [sleeve]),
  };
}

/** Grooving bars: a blade stands out of the bar by its depth, so that the least bore has room for both (recalled, tag K). */
const GROOVING: readonly (Bar & { readonly cutWidth: number })[] = [
  { d: 25, out: 5, leastBore: 31, length: 200, cutWidth: 3 },
  { d: 20, out: 4.5, leastBore: 25, length: 180, cutWidth: 2 },
  { d: 16, out: 3.5, leastBore: 20, length: 160, cutWidth: 2 },
  { d: 12, out: 2, leastBore: 15, length: 150, cutWidth: 2 },
  { d: 20, out: 2, leastBore: 23, length: 180, cutWidth: 1.1 },
  { d: 12, out: 1.5, leastBore: 14, length: 150, cutWidth: 1.1 },
];
/** The same for the grooves of circlips in bores: as wide as the groove of DIN 472 (m), for the bores that have it. */
const CIRCLIP: typeof GROOVING = [
  { d: 25, out: 3, leastBore: 31, length: 200, cutWidth: 2.65 },
  { d: 25, out: 2.5, leastBore: 31, length: 200, cutWidth: 2.15 },
  { d: 25, out: 2.5, leastBore: 31, length: 200, cutWidth: 1.85 },
  { d: 20, out: 2, leastBore: 25, length: 180, cutWidth: 1.6 },
  { d: 16, out: 1.5, leastBore: 20, length: 160, cutWidth: 1.3 },
];
/** Clearance of a blade behind its edge on each side, mm. */
const RELIEF = 0.2;

function groovingBar(bar: (typeof GROOVING)[number]): Cells {
  const { d, out: depth, cutWidth } = bar;
  const half = cutWidth / 2 - RELIEF;
  const blade: readonly Corner[] = [
    [-half, -depth / 2],
    [half, -depth / 2],
    [half, -depth],
    [-half, -depth],
  ];
  return {
    NAME: `ID-RECTURN-${cutWidth}-D${d}`,
    TYPE: "RECTURN",
    TO: "6",
    RS: cutWidth < 2 ? "0.1" : "0.2",
    CUTWIDTH: String(cutWidth),
    CUTLENGTH: String(rounded(depth)),
    ...shank(bar, -half, [blade]),
  };
}

/**
 * Threading bars SIR 0020, 0016, 0013 and 0010 with inserts of 16 and 11 mm: height of the tooth and width of the insert
 * beside it, mm (recalled, tag K).
 */
const THREADING: readonly (Bar & { readonly tooth: number; readonly beside: number })[] = [
  { d: 20, out: 4, leastBore: 25, length: 180, tooth: 2.5, beside: 1.4 },
  { d: 16, out: 3.5, leastBore: 20, length: 170, tooth: 2.5, beside: 1.4 },
  { d: 13, out: 3.7, leastBore: 17, length: 150, tooth: 2.5, beside: 1.4 },
  { d: 10, out: 2.4, leastBore: 13, length: 125, tooth: 1.2, beside: 0.9 },
];
/** Angles of usual threads: metric, unified and NPT; pipe threads. */
const ANGLES = [60, 55] as const;

function threadingBar(bar: (typeof THREADING)[number], angle: number): Cells {
  const { d, out: root, tooth, beside } = bar;
  const seat: readonly Corner[] = [
    [-beside, -tooth],
    [beside, -tooth],
    [2 * beside, -Math.max(root, tooth + beside)],
    [-beside, -Math.max(root, tooth + beside)],
  ];
  return {
    NAME: `THREAD-${angle}-ID-D${d}`,
    TYPE: "THREAD",
    TO: "6",
    RS: "0.1",
    "P-ANGLE": String(angle),
    CUTLENGTH: String(tooth),
    ...shank(bar, -beside, [seat]),
  };
}

function boringBar([code, leastBore, TYPE]: (typeof BORING)[number]): Cells {
  const { cells } = fillingOf(readToolCodes(code), { id: code, cells: {} });
  const [bar] = code.split("-");
  return {
    ...Object.fromEntries(cells.map(({ cell, to }) => [cell, to])),
    NAME: `BORE-${code.split(" ").slice(-2).join("")}-${bar}`,
    TYPE,
    DMIN: String(leastBore),
  };
}

const ROWS: readonly Cells[] = [
  ...BORING.map(boringBar),
  ...SOLID.map(solidBar),
  ...GROOVING.map(groovingBar),
  ...ANGLES.flatMap((angle) => THREADING.map((bar) => threadingBar(bar, angle))),
  ...CIRCLIP.map(groovingBar),
];
/** Their numbers follow this one. */
const BEHIND = 100;

/** Usual bars for boring, grooving and threading in a bore as rows of a table, each with a free number. */
export function standardBars(list: ToolList): readonly Cells[] {
  let last = BEHIND;
  return ROWS.map((cells) => ({ T: String((last = freeNumber(list, last))), ...cells }));
}
