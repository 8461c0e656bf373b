import { rounded } from "../../kernel/units.ts";
import { writeHead } from "../tools/holder-cells.ts";
import type { ToolEntry } from "../tools/tool-entry.ts";
import { freeNumber, type ToolList } from "../tools/tool-list.ts";

type Cells = ToolEntry["cells"];

/** A blade that cuts towards the axis, mm: width of its edge, how deep it goes, and the shank or block that holds it. */
interface Blade {
  readonly cutWidth: number;
  readonly depth: number;
  readonly shank: number;
  readonly length: number;
}

/**
 * Blades for the grooves of circlips on shafts: the edge is as wide as the groove of DIN 471 (m), which its tolerance H13
 * makes a little wider. How deep they go is recalled of usual inserts (tag K).
 */
const CIRCLIP: readonly Blade[] = [
  { cutWidth: 1.1, depth: 1.5, shank: 20, length: 125 },
  { cutWidth: 1.3, depth: 1.5, shank: 20, length: 125 },
  { cutWidth: 1.6, depth: 2, shank: 20, length: 125 },
  { cutWidth: 1.85, depth: 2.5, shank: 20, length: 125 },
  { cutWidth: 2.15, depth: 2.5, shank: 20, length: 125 },
  { cutWidth: 2.65, depth: 3, shank: 20, length: 125 },
];

/**
 * Parting blades in a block. They stand out by half of the largest bar that makers usually state for their width: ⌀100,
 * ⌀120 and ⌀160 (recalled, tag K).
 */
const PARTING: readonly Blade[] = [
  { cutWidth: 3, depth: 50, shank: 25, length: 150 },
  { cutWidth: 4, depth: 60, shank: 25, length: 150 },
  { cutWidth: 5, depth: 80, shank: 32, length: 225 },
];
/** Clearance of a blade behind its edge on each side, and height of the edge itself, mm. */
const [RELIEF, EDGE] = [0.2, 0.5];

function cellsOf(name: string, corner: number, { cutWidth, depth, shank, length }: Blade): Cells {
  const half = cutWidth / 2 - RELIEF;
  const head = [
    [-half, EDGE],
    [half, EDGE],
    [half, depth],
    [-half, depth],
  ];
  return {
    NAME: `${name}-${cutWidth}`,
    TYPE: "RECESS",
    TO: "2",
    RS: String(corner),
    CUTWIDTH: String(cutWidth),
    CUTLENGTH: String(depth),
    width: String(shank),
    length: String(rounded(length - depth)),
    offsetZ: String(rounded(-half)),
    offsetX: String(depth),
    head: writeHead([head] as unknown as Parameters<typeof writeHead>[0]),
  };
}

const ROWS: readonly Cells[] = [
  ...CIRCLIP.map((blade) => cellsOf("OD-CIRCLIP", 0.1, blade)),
  ...PARTING.map((blade) => cellsOf("PARTING", 0.2, blade)),
];
/** Their numbers follow this one. */
const BEHIND = 200;

/** Usual blades for the outside as rows of a table, each with a free number. */
export function standardBlades(list: ToolList): readonly Cells[] {
  let last = BEHIND;
  return ROWS.map((cells) => ({ T: String((last = freeNumber(list, last))), ...cells }));
}
