import type { Ring } from "../../kernel/geometry/point.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import type { Camera } from "../camera.ts";
import type { ChuckDrawing } from "./chuck.ts";
import {
  feedLines,
  seenInside,
  seenOutside,
  turnsInside,
  turnsOutside,
  type DrawnLine,
  type SeenEdge,
} from "./lines.ts";
import { paintChuck, paintFrontJaw } from "./paint-chuck.ts";
import { paintThread } from "./paint-thread.ts";
import type { Pen, Patch } from "./pen.ts";
import { boundaryIn, columnsOf, type Boundary, type Columns } from "./scan.ts";
import {
  acrossRadius,
  asPage,
  brush,
  halvesOf,
  trace,
  type Half,
  type SectionKind,
  type PaintTarget,
} from "./paint-target.ts";
import type { Surfaces } from "./surfaces.ts";
import { threadZones, type ThreadZone } from "./thread-zone.ts";

/** The work at one moment. */
export interface Material {
  /** Its section, outer rings counter-clockwise, mm. */
  readonly rings: readonly Ring[];
  readonly section: SectionKind;
  /** The moment, and the origin of the surfaces up to it. */
  readonly now: PlayPosition;
  readonly surfaces: Surfaces;
  readonly chuck: ChuckDrawing | null;
}

/** Pixels between two hatch lines, along the edge of the picture. */
const HATCH = 10;
/** Device columns scanned beside a patch. */
const BESIDE = 3;
/** An edge that rises less than this across the columns of a run is level there, pixels of the device. */
const LEVEL = 0.2;

/** Columns of a patch, one per device pixel, with the boundary in and beside them. */
function columnsIn({ rings, surfaces, now }: Material, { camera, ratio }: PaintTarget, { x, width }: Patch) {
  const first = Math.floor(x * ratio) - BESIDE,
    count = Math.ceil((x + width) * ratio) + BESIDE - first;
  const perColumn = 1 / (camera.scale * ratio),
    left = (first / ratio - camera.zero.x) / camera.scale;
  const more = 1.5 * surfaces.lead(now) + perColumn;
  const boundary = boundaryIn(rings, surfaces, now, left - more, left + count * perColumn + more);
  return { first, boundary, columns: columnsOf(boundary.edges, left, perColumn, count) };
}

/**
 * The angle of an edge to the axis, positive if the edge faces the free end. Outside, rings run to the left; inside, to
 * the right.
 */
function slopeAt({ edges }: Boundary, e: number, isInside: boolean): number {
  const edge = edges[e];
  return edge ? Math.atan2(edge.r1 - edge.r0, isInside ? edge.z1 - edge.z0 : edge.z0 - edge.z1) : 0;
}

/** Fills columns from `from` to `to` with the shade of an edge that is `r` mm from the axis, from `low` mm on. */
type FillColumns = (edge: number, columns: readonly [from: number, to: number], r: number, low: number) => void;

/** Calls for each run of columns whose outside is one level edge. */
function runsOutside({ count, top, edge }: Columns, level: number, fill: FillColumns): void {
  let from = 0;
  for (let j = 1; j <= count; j += 1) {
    const e = edge[from] as number,
      r = top[from] as number;
    if (j < count && edge[j] === e && Math.abs((top[j] as number) - r) < level) continue;
    if (e >= 0) fill(e, [from, j], r, 0);
    from = j;
  }
}

/** The same for the walls of hollows. */
function runsInside({ count, gaps }: Columns, level: number, fill: FillColumns): void {
  const open = new Map<number, { from: number; low: number; high: number }>();
  for (let j = 0; j <= count; j += 1) {
    const here = gaps[j] ?? [];
    for (const [edge, run] of open) {
      const gap = here.find((g) => g.edge === edge);
      if (gap && Math.abs(gap.high - run.high) < level && Math.abs(gap.low - run.low) < level) continue;
      fill(edge, [run.from, j], run.high, run.low);
      open.delete(edge);
    }
    for (const { edge, low, high } of here) if (!open.has(edge)) open.set(edge, { from: j, low, high });
  }
}

const isIn = (zones: readonly ThreadZone[], z: number) => zones.some((zone) => z >= zone.left && z < zone.right);

function shades(
  easel: PaintTarget,
  half: Half,
  first: number,
  boundary: Boundary,
  columns: Columns,
  zones: readonly ThreadZone[],
): void {
  const { pen, camera, ratio } = easel,
    level = LEVEL / (camera.scale * ratio);
  const own = zones.filter((zone) => zone.isInside === half.isCut);
  const fill: FillColumns = (edge, [from, to], r, low) => {
    if (own.length > 0 && isIn(own, columns.left + (from + to) * 0.5 * columns.width)) return;
    const texture = boundary.edges[edge]?.made.texture ?? "raw",
      slope = slopeAt(boundary, edge, half.isCut);
    pen.fillStyle = brush(easel, "steel", slope, texture, half.isCut ? "hole" : half.facing);
    acrossRadius(easel, half.down, r);
    // One more pixel over the axis avoids a seam between the halves.
    const begin = low > 0 ? low / r : -1 / (r * camera.scale);
    pen.fillRect((first + from) / ratio, begin, (to - from) / ratio, 1 - begin);
  };
  if (half.isCut) runsInside(columns, level, fill);
  else runsOutside(columns, level, fill);
  asPage(easel);
}

function strokes(easel: PaintTarget, down: 1 | -1, lines: readonly DrawnLine[]): void {
  if (lines.length === 0) return;
  easel.pen.beginPath();
  for (const { z0, r0, z1, r1 } of lines)
    trace(easel, down, [
      [z0, r0],
      [z1, r1],
    ]);
  easel.pen.stroke();
}

/** Feed marks, edges across, and the outline where it is not cut. */
function drawing(
  easel: PaintTarget,
  { down, isCut }: Half,
  boundary: Boundary,
  columns: Columns,
  zones: readonly ThreadZone[],
): void {
  const { pen, colours, camera } = easel;
  const free = <L extends DrawnLine>(lines: readonly L[]) => {
    const own = zones.filter((zone) => zone.isInside === isCut);
    return own.length === 0 ? lines : lines.filter((l) => !isIn(own, (l.z0 + l.z1) / 2));
  };
  const seen: readonly SeenEdge[] = free(isCut ? seenInside(boundary, columns) : seenOutside(boundary, columns));
  pen.strokeStyle = colours.edge;
  pen.lineWidth = 1;
  for (const { strength, lines } of feedLines(boundary, seen, camera.scale)) {
    pen.globalAlpha = 0.3 * strength;
    strokes(easel, down, lines);
  }
  pen.globalAlpha = isCut ? 0.6 : 0.75;
  strokes(easel, down, free(isCut ? turnsInside(boundary, columns) : turnsOutside(boundary, columns)));
  pen.globalAlpha = 1;
  if (!isCut) strokes(easel, down, seen);
}

/** Traces rings without the points beyond a window along Z: a row of points on one side of it becomes two. */
function traceNear(easel: PaintTarget, down: 1 | -1, rings: readonly Ring[], left: number, right: number): void {
  const beyond = (z: number) => (z < left ? -1 : Number(z > right));
  for (const ring of rings) {
    const places = ring.filter((p, i) => {
      const side = beyond(p.z),
        [a, b] = [ring[(i + ring.length - 1) % ring.length], ring[(i + 1) % ring.length]];
      return side === 0 || beyond(a?.z ?? 0) !== side || beyond(b?.z ?? 0) !== side;
    });
    if (places.length < 3) continue;
    trace(
      easel,
      down,
      places.map((p) => [p.z, p.r] as const),
    );
    easel.pen.closePath();
  }
}

function cutFace(easel: PaintTarget, down: 1 | -1, rings: readonly Ring[], { x, y, width, height }: Patch): void {
  const {
    pen,
    colours,
    camera: { zero, scale },
  } = easel;
  const near = () => {
    pen.beginPath();
    traceNear(easel, down, rings, (x - 4 - zero.x) / scale, (x + width + 4 - zero.x) / scale);
  };
  near();
  pen.fillStyle = colours.ground;
  pen.fill("evenodd");
  pen.save();
  pen.clip("evenodd");
  // The hatch is fixed to the work: it moves along, and regions meet without a seam.
  const begin = (zero.x + zero.y) % HATCH;
  pen.beginPath();
  for (let c = begin + Math.floor((x + y - begin) / HATCH) * HATCH; c < x + width + y + height; c += HATCH) {
    pen.moveTo(c - y, y);
    pen.lineTo(c - y - height, y + height);
  }
  pen.strokeStyle = colours.hatch;
  pen.lineWidth = 1;
  pen.stroke();
  pen.restore();
  near();
  pen.strokeStyle = colours.edge;
  pen.lineWidth = 1.25;
  pen.stroke();
}

/** Whether a patch may show part of the clamping. */
const isNear = ({ all, limit }: ChuckDrawing, { zero, scale }: Camera, { x }: Patch) =>
  x <= zero.x + Math.max(all.right, limit?.z ?? all.right) * scale + BESIDE;

/**
 * Repaints a patch of the picture: clears it first, and touches nothing outside it. The pen counts in CSS pixels from
 * the corner of the picture, before and after.
 */
export function paintMaterial(
  pen: Pen,
  material: Material,
  camera: Camera,
  look: Pick<PaintTarget, "colours" | "ratio" | "origin">,
  patch: Patch,
): void {
  const easel: PaintTarget = { pen, camera, ...look },
    { rings, section, chuck } = material;
  const halves = halvesOf(section, camera.xUp),
    near = chuck && isNear(chuck, camera, patch) ? chuck : null;
  const { first, boundary, columns } = columnsIn(material, easel, patch);
  const zones = threadZones(boundary);
  pen.save();
  asPage(easel);
  pen.beginPath();
  pen.rect(patch.x, patch.y, patch.width, patch.height);
  pen.clip();
  pen.clearRect(patch.x, patch.y, patch.width, patch.height);
  if (near) paintChuck(easel, halves, section, near);
  for (const half of halves) {
    shades(easel, half, first, boundary, columns, zones);
    drawing(easel, half, boundary, columns, zones);
    for (const zone of zones) if (zone.isInside === half.isCut) paintThread(easel, half, zone);
    if (half.isCut) cutFace(easel, half.down, rings, patch);
  }
  if (near) paintFrontJaw(easel, halves, section, near);
  pen.restore();
}
