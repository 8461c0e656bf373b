import type { Ring } from "../../kernel/point.ts";
import type { Tool } from "../../kernel/tool.ts";
import type { Camera, Size } from "../camera.ts";
import type { SectionKind } from "../material/easel.ts";
import { toolBox } from "./drawing.ts";

/** A part of the picture, as what is left out of it on each side, pixels. */
export interface PictureWindow {
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
  readonly left: number;
}

/** Where a tool inside of the work is seen, and what becomes of the rest of it. */
export interface Windows {
  readonly seen: PictureWindow;
  /** The second part; it is drawn as well, or `hidden`: only as edges behind the work. */
  readonly other: PictureWindow;
  readonly isHidden: boolean;
}

const ALL: PictureWindow = { top: 0, right: 0, bottom: 0, left: 0 };

/** Whether a tool lies towards the axis from its tip, as boring bars and drills do: the work can stand between it and who looks. */
export function liesInward(tool: Tool): boolean {
  const box = toolBox(tool);
  return box !== null && -box.low >= box.high;
}

/** Where the work ends at its free end, mm; without work, nowhere. */
export const frontOf = (rings: readonly Ring[]): number =>
  rings.reduce((most, ring) => ring.reduce((far, { z }) => Math.max(far, z), most), -Infinity);

/**
 * The windows through which a tool that lies inward is seen. A half section is open on the tool's side of the axis; on the other side, and
 * in a view from outside on both, the work covers what is left of its free end, `front` mm. Null where all of the tool is seen.
 */
export function windowsOf(section: SectionKind, { scale, zero, xUp }: Camera, { width, height }: Size, front: number): Windows | null {
  if (section === "full" || front === -Infinity) return null;
  const face = zero.x + front * scale;
  if (section === "outside") return { seen: { ...ALL, left: face }, other: { ...ALL, right: width - face }, isHidden: true };
  const [above, below] = [{ ...ALL, bottom: height - zero.y }, { ...ALL, top: zero.y }] as const;
  const [open, closed] = xUp ? [above, below] : [below, above];
  return { seen: open, other: { ...closed, left: face }, isHidden: false };
}

/** A window as the value of CSS `clip-path`; one that lies beside the picture shows nothing, or all. */
export const clipOf = ({ top, right, bottom, left }: PictureWindow): string =>
  `inset(${[top, right, bottom, left].map((side) => `${Math.max(0, side)}px`).join(" ")})`;
