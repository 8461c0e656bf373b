import { areaOf, areaOfRing } from "../../kernel/area/area.ts";
import { boxAround, boxOf } from "../../kernel/area/box.ts";
import { intersection, offset, union } from "../../kernel/area/clip.ts";
import { isDrill } from "../../kernel/cutter/drill.ts";
import { holderOutlines, shankAxis } from "../../kernel/cutter/holder.ts";
import {
  flanksUnknown,
  insertOutline,
  insertShape,
  isBar,
  correctionShift,
  tipDirection,
} from "../../kernel/cutter/insert.ts";
import { at, part, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import { CHORD } from "../../kernel/tolerance.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { rightOf } from "../../sim/sweep.ts";
import { ringData, startData } from "../path.ts";

/** What a line or an area of a drawn tool stands for; how it looks belongs to whoever paints it. */
export type ToolRole =
  | "holder"
  | "seam"
  | "centre"
  | "pocket"
  | "rest"
  | "insert"
  | "guess"
  | "relief"
  | "screw"
  | "drive";

/** One shape of a tool: path data relative to the theoretical tip (x = z, y = r, mm). */
export interface ToolShape {
  readonly role: ToolRole;
  readonly d: string;
}

/** The land behind a cutting edge, and the clearance of a pocket, as parts of the largest circle in an insert. */
const LAND = 0.13;
const CLEAR = 0.06;
/** The hole of an insert and the screw or lever in it, likewise: inserts of 12.7 mm have holes of 5.16 mm. */
const HOLE = 0.4;
const SCREW = 0.24;
/** How far the insert of a blade reaches out of it, in widths of its edge. */
const OUT_OF_BLADE = 2.4;
/** Corners of the drive of a screw. */
const CORNERS = 6;
/** Lead of the flutes of a drill, in diameters. */
const LEAD = 3.2;

/** The centre of an area. */
function centreOf(ring: Ring): Pt {
  let [z, r] = [0, 0];
  ring.forEach((p, i) => {
    const q = ring[(i + 1) % ring.length] as Pt,
      twice = p.z * q.r - q.z * p.r;
    z += (p.z + q.z) * twice;
    r += (p.r + q.r) * twice;
  });
  const sum = 6 * areaOfRing(ring);
  return sum > 0 ? at(z / sum, r / sum) : at(0, 0);
}

/** How far a place inside a convex ring is from its nearest side, mm. */
const depthIn = (ring: Ring, p: Pt): number =>
  Math.min(...ring.map((from, i) => part.distanceTo({ kind: "line", from, to: ring[(i + 1) % ring.length] as Pt }, p)));

const polygon = (centre: Pt, radius: number, corners: number): Ring =>
  Array.from({ length: corners }, (_, i) => part.onCircle(centre, radius, (2 * Math.PI * i) / corners));

/** A whole circle as two arcs. */
function circleData({ z, r }: Pt, radius: number): string {
  const [left, right] = [startData(at(z - radius, r)), startData(at(z + radius, r)).slice(1)];
  const size = startData(at(radius, radius)).slice(1);
  return `${left}A${size} 0 0 0 ${right}A${size} 0 0 0 ${left.slice(1)}Z`;
}

const lineData = (from: Pt, to: Pt) => `${startData(from)}L${startData(to).slice(1)}`;

/** The part of a blade's insert that sticks out of its blade; all of it without a holder. */
export function outOfBlade(tool: Tool, ring: Ring): Ring {
  const edge = insertShape(tool).find((e) => e.feature === "width");
  if (!isBar(tool) || !tool.holder || edge?.kind !== "line") return ring;
  const shift = correctionShift(tool),
    on = (p: { readonly u: number; readonly v: number }) => at(p.u + shift.u, p.v + shift.v);
  const [from, to] = [on(edge.from), on(edge.to)],
    inwards = part.leftOf(part.direction({ kind: "line", from, to }, from));
  const { left, right, low, high } = boxOf(ring),
    deep = Math.min(right - left, high - low) * OUT_OF_BLADE;
  // The part towards the edge is to the right of the same line moved inwards.
  const front = rightOf(ring, part.beyond(from, inwards, deep), part.beyond(to, inwards, deep));
  return front.length > 2 ? front : ring;
}

/** Hole and clamp of an insert: a screw or a lever; the tool table does not say which. */
function clampOf(ring: Ring): ToolShape[] {
  const centre = centreOf(ring),
    room = depthIn(ring, centre);
  return [
    { role: "screw", d: circleData(centre, room * HOLE) },
    { role: "screw", d: circleData(centre, room * SCREW) },
    {
      role: "drive",
      d: ringData([polygon(centre, (room * SCREW) / 2, CORNERS)]),
    },
  ];
}

/** The flutes of a drill from the side, and its axis. */
function groovesOf(ring: Ring): ToolShape[] {
  const { left, right, low, high } = boxOf(ring),
    size = high - low,
    middle = (low + high) / 2,
    over = size / 4,
    way = (size * LEAD) / 2;
  const grooves: string[] = [];
  for (let z = left + size / 2; size > 0 && z + way / 2 < right; z += way)
    grooves.push(lineData(at(z, low), at(z + way / 2, high)));
  return [
    { role: "relief", d: grooves.join("") },
    { role: "centre", d: lineData(at(left - over, middle), at(right + over, middle)) },
  ];
}

/** The axis of a round boring bar, if its shank lies along Z and it cuts outwards. */
function axisOf(tool: Tool): ToolShape[] {
  const shank = holderOutlines(tool).at(-1),
    { u, v } = tipDirection(tool.TO);
  if (!shank || !tool.holder || shankAxis(tool.TO, tool.holder.axis) !== "Z" || v <= 0 || u > 0) return [];
  const { left, right, low, high } = boxOf(shank),
    over = (high - low) / 4;
  return [{ role: "centre", d: lineData(at(left - over, (low + high) / 2), at(right + over, (low + high) / 2)) }];
}

/** Where the head of a holder joins its shank: the near end of the shank, as far as it is inside the holder. */
function seamOf(tool: Tool, whole: readonly Ring[]): ToolShape[] {
  const shank = holderOutlines(tool).at(-1);
  if (!shank || !tool.holder?.head?.length) return [];
  const { left, right, low, high } = boxOf(shank),
    { u, v } = tipDirection(tool.TO),
    thin = Math.min(right - left, high - low) / 100;
  const along = shankAxis(tool.TO, tool.holder.axis) === "Z";
  const z = u > 0 ? right : left,
    r = v > 0 ? high : low;
  const [from, to] = along ? [at(z, low), at(z, high)] : [at(left, r), at(right, r)];
  const inside = part.pointOn({ kind: "line", from, to }, 0.5);
  const beyond = along
    ? at(inside.z + (u > 0 ? thin : -thin), inside.r)
    : at(inside.z, inside.r + (v > 0 ? thin : -thin));
  return areaOf(intersection(whole, [polygon(beyond, thin / 2, CORNERS)])) > 0
    ? [{ role: "seam", d: lineData(from, to) }]
    : [];
}

/**
 * A tool as shapes, from back to front: the holder in one piece, the pocket, the insert with its land, and its clamp.
 * The outlines are the simulated ones; a tool without a holder has none drawn. Shank lengths come from the tool table.
 */
export function toolShapes(tool: Tool): readonly ToolShape[] {
  const ring = insertOutline(tool, CHORD),
    front = outOfBlade(tool, ring),
    holder = union(holderOutlines(tool));
  if (ring.length < 3) return [];
  if (isDrill(tool)) return [{ role: "insert", d: ringData([ring]) }, ...groovesOf(ring)];
  const room = depthIn(front, centreOf(front)),
    shapes: ToolShape[] = [];
  if (holder.length > 0) {
    const pocket = intersection(holder, offset([front], room * CLEAR + CLEAR));
    shapes.push({ role: "holder", d: ringData(holder) }, ...seamOf(tool, holder), ...axisOf(tool), {
      role: "pocket",
      d: ringData(pocket),
    });
  }
  if (front !== ring) shapes.push({ role: "rest", d: ringData([ring]) });
  shapes.push({ role: flanksUnknown(tool) ? "guess" : "insert", d: ringData([front]) });
  const land = offset([front], -room * LAND);
  if (land.length > 0 && !flanksUnknown(tool)) shapes.push({ role: "relief", d: ringData(land) });
  // Of a thread insert only the tooth is known, and its screw is elsewhere.
  const unclamped = isBar(tool) || tool.TYPE === "THREAD" || flanksUnknown(tool);
  return unclamped ? shapes : [...shapes, ...clampOf(front)];
}

/** The box round a whole tool, relative to its tip; null where it has no outline. */
export function toolBox(tool: Tool): ReturnType<typeof boxAround> | null {
  const ring = insertOutline(tool, CHORD);
  return ring.length > 2 ? boxAround([ring, ...holderOutlines(tool)]) : null;
}
