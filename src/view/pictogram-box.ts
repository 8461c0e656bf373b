/**
 * A cycle drawn for a menu, in a box: path data of the part, of what is cut off it, and of the contour between them.
 */
export interface Pictogram {
  readonly body: string;
  readonly cut: string;
  readonly contour: string;
  /**
   * How the tool goes through what it cuts: side to side, in and out, sinking from side to side, or along the contour.
   */
  readonly passes: "along" | "across" | "sinking" | "profile";
}

/** Size of the box, and the height of the spindle axis in it. */
export const PICTOGRAM = { width: 64, height: 48, axis: 45 } as const;
