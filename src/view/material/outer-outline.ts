import type { Ring } from "../../kernel/geometry/point.ts";
import { boundsOf } from "../bounds.ts";
import { seenOutside, type DrawnLine } from "./lines.ts";
import { boundaryIn, columnsOf } from "./scan.ts";
import { UNTOUCHED } from "./surfaces.ts";

/** Columns in the scan of a stock; details narrower than one column are lost. */
const COLUMNS = 4096;

const START = { step: 0, fraction: 0 };

/**
 * The outer outline of a stock as SVG path data in part space: from the axis along the upper outline and back to the
 * axis.
 */
export function outerOutlineData(rings: readonly Ring[]): string {
  const box = boundsOf(rings.flat());
  if (!box) return "";
  const width = (box.right - box.left) / COLUMNS,
    boundary = boundaryIn(rings, UNTOUCHED, START, box.left, box.right);
  let data = "",
    last: DrawnLine | null = null;
  for (const line of seenOutside(boundary, columnsOf(boundary.edges, box.left, width, COLUMNS))) {
    const joins = last && line.z0 - last.z1 < 2 * width;
    if (!joins) data += `${last ? `L${last.z1} 0` : ""}M${line.z0} 0`;
    data += `L${line.z0} ${line.r0}L${line.z1} ${line.r1}`;
    last = line;
  }
  return last ? `${data}L${last.z1} 0` : "";
}
