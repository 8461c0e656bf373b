import { holderOutlines } from "../kernel/cutter/holder.ts";
import { flanksUnknown, insertOutline } from "../kernel/cutter/insert.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import { CHORD } from "../kernel/tolerance.ts";
import type { Tool } from "../kernel/plan/tool.ts";

/** The shape of a tool: convex polygons relative to the theoretical tip. */
export interface Outlines {
  readonly insert: Ring;
  /** The part checked for contact: the insert, or only its nose where the flanks are unknown. */
  readonly checked: Ring;
  /** The parts of the holder; none when the tool has none. */
  readonly holder: readonly Ring[];
}

/** Caches the outlines of a run, so that each tool is flattened once. */
export function outlinesOf(): (tool: Tool) => Outlines {
  const known = new Map<Tool, Outlines>();
  return (tool) => {
    const have = known.get(tool);
    if (have) return have;
    const insert = insertOutline(tool, CHORD);
    const made = {
      insert,
      checked: flanksUnknown(tool) ? insertOutline(tool, CHORD, false) : insert,
      holder: holderOutlines(tool),
    };
    known.set(tool, made);
    return made;
  };
}
