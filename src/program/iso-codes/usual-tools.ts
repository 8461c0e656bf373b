import { standardDrills } from "../tools/standard-drills.ts";
import { standardReamers } from "../tools/standard-reamers.ts";
import type { ShopTools } from "../tools/read-tools.ts";
import type { ToolEntry } from "../tools/tool-entry.ts";
import { readList, shippedList, type ToolList } from "../tools/tool-list.ts";
import { standardBars } from "./standard-bars.ts";
import { standardBlades } from "./standard-blades.ts";
import { standardUndercutTools } from "./standard-undercut-tools.ts";

/** Cells that make two tools alike whatever their names: those of drills and taps, of blades, and of turning tools. */
const LIKE = {
  axis: ["TYPE", "R", "PITCH"],
  blade: ["TYPE", "TO", "RS", "CUTWIDTH", "CUTLENGTH", "width", "axis"],
  turning: ["TYPE", "TO", "RS", "T-ANGLE", "P-ANGLE", "width", "axis"],
} as const;

/** What a tool has in common with like ones; the name of a centre drill, which states its hole. */
function likeness({ cells }: ToolEntry): string {
  if (cells.TYPE === "CENTER") return cells.NAME ?? "";
  const turning = cells.CUTWIDTH === undefined ? LIKE.turning : LIKE.blade;
  const columns = cells.R === undefined ? turning : LIKE.axis;
  return columns.map((cell) => Number(cells[cell]) || (cells[cell] ?? "")).join();
}

/**
 * Usual tools that a table lacks, with free numbers: drills, taps, centre drills, bars for bores, tools for undercuts, and
 * blades for circlips and for parting off, and reamers with the drills before them.
 * The table has one already where the name or the shape is the same.
 */
export function usualTools(list: ToolList): readonly ToolEntry[] {
  const names = new Set(list.map(({ cells }) => cells.NAME));
  const shapes = new Set(list.map(likeness));
  return [standardDrills, standardUndercutTools, standardBars, standardBlades, standardReamers]
    .flatMap((rowsOf) => rowsOf(list))
    .map((cells) => ({ id: `usual ${cells.T}`, cells }))
    .filter((entry) => !names.has(entry.cells.NAME) && !shapes.has(likeness(entry)));
}

/** A table with the usual tools that it lacks, and their numbers. */
export function withUsualTools(list: ToolList): { readonly table: ShopTools; readonly usual: readonly number[] } {
  const usual = usualTools(list);
  return { table: readList([...list, ...usual]).table, usual: usual.map(({ cells }) => Number(cells.T)) };
}

/** The built-in tools with the usual ones, and the numbers of these. */
export const builtInTools = withUsualTools(shippedList);
