import { union } from "../../kernel/area/clip.ts";
import { holderOutlines } from "../../kernel/cutter/holder.ts";
import { insertOutline } from "../../kernel/cutter/insert.ts";
import { at, type Ring } from "../../kernel/geometry/point.ts";
import { CHORD } from "../../kernel/tolerance.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { boundsOf } from "../bounds.ts";
import type { Bounds, Place } from "../camera.ts";
import { outOfBlade } from "../cutting-tool/drawing.ts";
import { ringData } from "../path.ts";
import { factorOf, usualScale, type DrawingScale } from "../drawing/scales.ts";

/** A tool at its tip to a usual scale, mm on paper: Z to the right, X up. */
export interface ToolPicture {
  readonly scale: DrawingScale;
  readonly insert: string;
  /** Empty without one. */
  readonly holder: string;
  /** The theoretical tip. */
  readonly tip: Place;
}

/** Free room round the insert, mm on paper. */
const AIR = 0.7;

/** Size of a picture, mm on paper. */
interface Room {
  readonly wide: number;
  readonly tall: number;
}

function pictured(insert: readonly Ring[], held: readonly Ring[], box: Bounds, { wide, tall }: Room): ToolPicture {
  const scale = usualScale(
    { wide: box.right - box.left, tall: box.high - box.low },
    { wide: wide - AIR - AIR, tall: tall - AIR - AIR },
  );
  const k = factorOf(scale);
  // The picture is centred on the insert; the holder is cut off at its edge.
  const middle = { z: (box.left + box.right) / 2, x: (box.low + box.high) / 2 };
  const tip = { x: wide / 2 - middle.z * k, y: tall / 2 + middle.x * k };
  const onPaper = (rings: readonly Ring[]) =>
    ringData(rings.map((ring) => ring.map((p) => at(tip.x + p.z * k, tip.y - p.r * k))));
  return { scale, insert: onPaper(insert), holder: onPaper(held), tip };
}

/**
 * The insert of a turning tool, or the point of a drill, with the near end of its holder, in a picture of so many mm.
 */
export function toolPicture(tool: Tool, room: Room): ToolPicture | null {
  const ring = insertOutline(tool, CHORD),
    box = boundsOf(ring);
  return box && pictured([outOfBlade(tool, ring)], union(holderOutlines(tool)), box, room);
}

/** A mill from the side: its edges, as wide as it is. */
export function millPicture(
  { R, LCUTS }: { readonly R: number; readonly LCUTS?: number },
  room: Room,
): ToolPicture | null {
  if (R <= 0) return null;
  const long = LCUTS !== undefined && LCUTS > 0 ? LCUTS : R * 3;
  const ring = [at(-R, 0), at(R, 0), at(R, long), at(-R, long)];
  const box = boundsOf(ring);
  return box && pictured([ring], [], box, room);
}
