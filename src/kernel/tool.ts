import type { Degrees, Length } from "./units.ts";

export const TOOL_TYPES = ["ROUGH", "FINISH", "RECESS", "RECTURN", "BUTTON", "THREAD"] as const;
export type ToolType = (typeof TOOL_TYPES)[number];
/** Tip orientation 1..9, as on HEIDENHAIN lathes. */
export type TipOrientation = 1 | 2 | 3 | 4 | 5 | 6 | 7 | 8 | 9;

/** A holder box for the collision check only: it never changes a path. All mm. */
export interface Holder {
  readonly width: Length;
  readonly length: Length;
  /** From the theoretical tip to the near corner of the holder, along Z and X (radius). */
  readonly offsetZ: Length;
  readonly offsetX: Length;
}

/** One row of the turning-tool table, by the names of its columns. mm and degrees; a missing cell is absent. */
export interface Tool {
  readonly T: number;
  readonly NAME: string;
  readonly TYPE: ToolType;
  readonly TO: TipOrientation;
  readonly RS: Length;
  readonly ZL?: Length;
  readonly XL?: Length;
  readonly DZL?: Length;
  readonly DXL?: Length;
  readonly DRS?: Length;
  readonly ORI?: Degrees;
  readonly "T-ANGLE"?: Degrees;
  readonly "P-ANGLE"?: Degrees;
  readonly CUTLENGTH?: Length;
  readonly CUTWIDTH?: Length;
  readonly DCW?: Length;
  readonly holder?: Holder;
  /** FUNCTION TURNDATA CORR: how far the insert stands from the tip the control counts with, along Z and X (radius). */
  readonly correction?: { readonly z: Length; readonly r: Length };
}
