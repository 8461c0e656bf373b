import type { Tool } from "../../kernel/plan/tool.ts";
import { pointAngleOf } from "../../kernel/cutter/drill.ts";
import { degrees, length } from "../../kernel/units.ts";
import type { Mill } from "./plane-types.ts";

/** A drill of the milling table as a tool for turning on the axis; null for a mill. An empty cell may be 0. */
export function drillOf(row: Mill): Tool | null {
  if (!row.TYPE || !(row.R + (row.DR ?? 0) > 0)) return null;
  const radius = row.R + (row.DR ?? 0);
  const angle = row["T-ANGLE"] ? degrees(row["T-ANGLE"]) : row.PL ? pointAngleOf(radius, row.PL) : null;
  return {
    T: row.T,
    NAME: row.NAME,
    TYPE: row.TYPE,
    TO: 8,
    RS: length(0),
    R: length(radius),
    ...(row.TYPE !== "TAP" && angle && { "T-ANGLE": angle }),
    ...(row.LCUTS && { CUTLENGTH: length(row.LCUTS) }),
    ...(row.PITCH && { PITCH: length(row.PITCH) }),
  };
}
