import { isDrill } from "../../kernel/cutter/drill.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { cutThread, type NamedThread } from "../../kernel/thread/named-thread.ts";
import { radius, rounded, toDiameter } from "../../kernel/units.ts";
import type { ToolEntry } from "./tool-entry.ts";

type Cells = ToolEntry["cells"];

/** Sizes of taps and threads this near are the same, mm. */
const SAME_SIZE = 0.05;
/** Steps of the diameters of drills per mm. */
const TENTH = 10;
/** Point angle of a usual drill, degrees. */
const POINT = "118";

/** Whether a thread is made with a tap: a cylindrical internal one with one start and no flat root. */
export const hasTap = ({ inside, side, flatRoot, taper, starts }: NamedThread): boolean =>
  inside !== null && side !== "outside" && !flatRoot && taper === 0 && starts === 1;

/** Whether a tap cuts a thread. */
export const isTapOf = (tool: Tool, { nominal, pitch }: NamedThread): boolean =>
  tool.TYPE === "TAP" &&
  Math.abs(toDiameter(radius(tool.R ?? 0)) - nominal) <= SAME_SIZE &&
  Math.abs((tool.PITCH ?? 0) - pitch) <= SAME_SIZE / 10;

/** The hole before a tap: its diameter and the limits of the minor diameter, mm; null without an internal thread. */
export function coreOf({
  inside,
}: NamedThread): { readonly size: number; readonly limits: readonly [number, number] } | null {
  if (!inside) return null;
  const middle = cutThread(inside, "middle").crest;
  const limits = inside.tolerance?.crest ?? ([inside.crest, inside.crest + SAME_SIZE] as const);
  const near = Math.round(middle * TENTH) / TENTH;
  return { size: near >= limits[0] && near <= limits[1] ? near : rounded(middle), limits };
}

/** Whether a drill makes the hole before a tap. */
export function isCoreDrill(tool: Tool, thread: NamedThread): boolean {
  const limits = coreOf(thread)?.limits;
  const across = toDiameter(radius(tool.R ?? 0));
  return isDrill(tool) && tool.TYPE !== "TAP" && !tool.centre && !!limits && across >= limits[0] && across <= limits[1];
}

/** Rows of a tap for a thread and the drill before it, without numbers; none for a thread without a tap. */
export function tapRows(thread: NamedThread): readonly Cells[] {
  const core = coreOf(thread);
  if (!core || !hasTap(thread)) return [];
  return [
    { NAME: `DRILL-D${core.size}`, TYPE: "DRILL", R: String(core.size / 2), "T-ANGLE": POINT },
    {
      NAME: `TAP-${thread.name.replace("×", "x").replace(/ /g, "-")}`,
      TYPE: "TAP",
      R: String(rounded(thread.nominal / 2)),
      PITCH: String(rounded(thread.pitch)),
    },
  ];
}
