import { holderOutlines } from "../kernel/cutter/holder.ts";
import { insertOutline } from "../kernel/cutter/insert.ts";
import type { Pt } from "../kernel/geometry/point.ts";
import type { Tool } from "../kernel/plan/tool.ts";
import { boundsOf } from "./bounds.ts";
import { toScreen, type Bounds, type Camera, type Size } from "./camera.ts";
import { arrange, type Item, type Spot } from "./dimensions/arrange.ts";
import { textWidth, type LabelBox } from "./dimensions/labels.ts";

/** A line across a picture with its text: level at a height, or upright at a place along Z, pixels. */
export interface NamedLine {
  readonly text: string;
  readonly way: "level" | "upright";
  readonly at: number;
}

/** Text size, its height, and its distance from its line and from the edge of the picture, pixels. */
const [SIZE, HEIGHT, OFF, EDGE] = [12, 15, 4, 8];
/** Texts of level lines start so many widths from the edge; those of upright lines in so many rows. */
const [COLUMNS, ROWS] = [4, 6];
/** Cost of the other side of a line, of the next column or row, and of the far edge. */
const COST = { side: 1, next: 2, far: 4 } as const;

/** Candidate places of a text: at the edge where it is looked for, farther from it, at the far edge. */
function spotsOf({ text, way, at }: NamedLine, room: LabelBox): readonly Spot[] {
  const width = Math.ceil(textWidth(text, SIZE)),
    [right, bottom] = [room.x + room.width, room.y + room.height];
  const spot = (x: number, y: number, cost: number): Spot => ({
    label: { x, y, width, height: HEIGHT },
    lines: [],
    cost,
  });
  if (way === "level") {
    const sides = [at - OFF - HEIGHT, at + OFF];
    const columns = Array.from({ length: COLUMNS }, (_, i) => [right - EDGE - width - i * (width + EDGE), i] as const);
    return sides.flatMap((y, side) => [
      ...columns.map(([x, i]) => spot(x, y, i * COST.next + side * COST.side)),
      spot(room.x + EDGE, y, COST.far + side * COST.side),
    ]);
  }
  const sides = [at + OFF, at - OFF - width];
  return sides.flatMap((x, side) =>
    Array.from({ length: ROWS }, (_, i) => [
      spot(x, room.y + i * HEIGHT, i * COST.next + side * COST.side),
      spot(x, bottom - EDGE - (i + 1) * HEIGHT, COST.far + i * COST.next + side * COST.side),
    ]).flat(),
  );
}

/** Boxes of the texts of lines, in their order, clear of each other and, if possible, of the `kept` areas. */
export function namedLines(
  lines: readonly NamedLine[],
  room: LabelBox,
  kept: readonly LabelBox[],
): readonly LabelBox[] {
  const inside = (b: LabelBox) =>
    b.x >= room.x && b.x + b.width <= room.x + room.width && b.y >= room.y && b.y + b.height <= room.y + room.height;
  const items = lines.map((line, i): Item<Spot> => {
    const candidates = spotsOf(line, room);
    const seen = candidates.filter(({ label }) => inside(label));
    return { q: String(i), candidates: seen.length > 0 ? seen : candidates, needed: true };
  });
  const size: Size = { width: room.x + room.width, height: room.y + room.height };
  return arrange(items, { ...size, avoid: [], kept }).map(({ label }) => label);
}

/** Chord tolerance of a tool when only its size counts, mm. */
const COARSE = 0.2;
const boxes = new WeakMap<Tool, Bounds | null>();

/** The box round insert and holder of a tool from its tip. Cached, since every picture needs it. */
function toolBounds(tool: Tool): Bounds | null {
  const known = boxes.get(tool);
  if (known !== undefined) return known;
  const box = boundsOf([...insertOutline(tool, COARSE), ...holderOutlines(tool).flat()]);
  boxes.set(tool, box);
  return box;
}

/** The box on the screen round a tool with its tip at a place. */
export function toolArea(tool: Tool, tip: Pt, camera: Camera): LabelBox | null {
  const box = toolBounds(tool);
  if (!box) return null;
  const corner = (z: number, r: number) => toScreen(camera, { z: (tip.z + z) as Pt["z"], r: (tip.r + r) as Pt["r"] });
  const [a, b] = [corner(box.left, box.low), corner(box.right, box.high)];
  return { x: Math.min(a.x, b.x), y: Math.min(a.y, b.y), width: Math.abs(a.x - b.x), height: Math.abs(a.y - b.y) };
}
