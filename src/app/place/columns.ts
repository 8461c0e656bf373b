import { create } from "zustand";
import { z } from "zod/mini";
import { storedData } from "../base/storage.ts";
import type { WorkKind } from "./place.ts";

/** The columns on both sides of the picture. */
export type Side = "left" | "right";

/** Limits of a column, units of lettering. The upper limit leaves room for the picture in any window. */
export const NARROWEST: Readonly<Record<Side, number>> = { left: 280, right: 200 };
export const WIDEST_SHARE = 0.4;

const width = z.optional(z.number().check(z.positive(), z.maximum(4000)));
const columns = z.object({ left: width, right: width });
const shape = z.object({ cycle: z.catch(columns, {}), program: z.catch(columns, {}) });

/** Chosen widths, units of lettering; a column that nobody has resized has none, and the style sheet decides. */
export type Columns = Readonly<z.output<typeof shape>>;

const KEPT = storedData<Columns>("columns", shape);

export const useColumns = create<Columns>(() => KEPT.get() ?? { cycle: {}, program: {} });

/** Resizes a column; undefined: back to the width of the style sheet. */
export function setColumn(of: WorkKind, side: Side, width: number | undefined): void {
  useColumns.setState((all) => ({ [of]: { ...all[of], [side]: width } }));
  KEPT.set(useColumns.getState());
}

/** A width within the limits; `room` is the width of the workplace. */
export const limited = (side: Side, width: number, room: number): number =>
  Math.round(Math.max(NARROWEST[side], Math.min(width, widest(side, room))));

/** The largest width of a column in a workplace. */
export const widest = (side: Side, room: number): number => Math.round(Math.max(NARROWEST[side], room * WIDEST_SHARE));

/** Step of an arrow key, units of lettering. */
const STEP = 16;

/** The width after a key on the separator; null: not a key of separators, undefined: the width of the style sheet. */
export function widthByKey(
  key: string,
  side: Side,
  { width, room, step = STEP }: { readonly width: number; readonly room: number; readonly step?: number },
): number | null | undefined {
  const outwards = side === "left" ? 1 : -1;
  switch (key) {
    case "ArrowLeft":
      return limited(side, width - outwards * step, room);
    case "ArrowRight":
      return limited(side, width + outwards * step, room);
    case "Home":
      return NARROWEST[side];
    case "End":
      return widest(side, room);
    case "Enter":
      return undefined;
    default:
      return null;
  }
}
