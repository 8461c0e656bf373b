import type { Pt } from "../../kernel/geometry/point.ts";
import type { Chip } from "../../sim/chip/chip.ts";
import type { Place } from "../camera.ts";
import { ringData, segmentData } from "../path.ts";

/** A chip as path data relative to the tip (x = z, y = r, mm). */
export interface DrawnChip {
  readonly area: string;
  /** The edge in contact. */
  readonly edge: string;
}

const NO_CHIP: DrawnChip = { area: "", edge: "" };

const lineData = (line: readonly Pt[]) =>
  segmentData(line.slice(1).map((to, i) => ({ kind: "line", from: line[i] as Pt, to })));

/** The shapes of a chip; empty without one. */
export const drawnChip = (chip: Chip | null): DrawnChip =>
  chip ? { area: ringData(chip.rings), edge: chip.contact.map(lineData).join("") } : NO_CHIP;

/** A chip thinner than this on the screen has no room for its numbers, pixels. */
const LEAST = 7;
/** Distance from the edge to the text, and half the ticks at the ends of the measure, pixels. */
const [BESIDE, TICK] = [16, 3];

/** The measure of a chip's thickness on the screen, pixels from the tip. */
export interface ChipMeasure {
  /** Across the chip with a tick at each end, and on to the text. */
  readonly line: string;
  readonly text: Place;
  readonly anchor: "start" | "end";
}

const n = (v: number) => Math.round(v * 10) / 10;

/** Where the thickness of a chip is written, at a scale in pixels per mm; null if the chip is too thin to see. */
export function chipMeasure({ thickest: { from, to, size } }: Chip, scale: number, xUp: boolean): ChipMeasure | null {
  if (size * scale < LEAST) return null;
  const place = (p: Pt): Place => ({ x: p.z * scale, y: (xUp ? -1 : 1) * p.r * scale });
  const [edge, back] = [place(from), place(to)],
    long = Math.hypot(edge.x - back.x, edge.y - back.y);
  const out = { x: (edge.x - back.x) / long, y: (edge.y - back.y) / long };
  const end = { x: edge.x + out.x * BESIDE, y: edge.y + out.y * BESIDE };
  const tick = ({ x, y }: Place) =>
    `M${n(x - out.y * TICK)} ${n(y + out.x * TICK)}L${n(x + out.y * TICK)} ${n(y - out.x * TICK)}`;
  return {
    line: `M${n(back.x)} ${n(back.y)}L${n(end.x)} ${n(end.y)}${tick(edge)}${tick(back)}`,
    text: { x: n(end.x + Math.sign(out.x || 1) * 4), y: n(end.y + (out.y > 0 ? 12 : 0)) },
    anchor: out.x < 0 ? "end" : "start",
  };
}
