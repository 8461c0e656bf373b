import contourEnglish from "./contour-en.h?raw";
import contour from "./contour.h?raw";
import flange from "./flange.h?raw";
import groove from "./groove.h?raw";
import plate from "./plate.h?raw";
import shaft from "./shaft.h?raw";
import shoulder from "./shoulder.h?raw";

/** Programs that ship with the app; their titles are in `i18n`, under the same names. */
export type ExampleId = "shaft" | "flange" | "shoulder" | "contour" | "contourEnglish" | "groove" | "plate";

export interface Example {
  readonly id: ExampleId;
  /** Complete Klartext program. */
  readonly text: string;
}

/**
 * In the order in which they are offered: two parts of our own from blank to finish, then the cycles of the
 * printed pages with their values and labels (misprints put right) in a frame of ours, and a milled plate with approach
 * and departure whose contours are the printed ones.
 */
export const examples: readonly Example[] = [
  { id: "shaft", text: shaft },
  { id: "flange", text: flange },
  { id: "shoulder", text: shoulder },
  {
    id: "contour",
    text: contour,
  },
  { id: "contourEnglish", text: contourEnglish },
  { id: "groove", text: groove },
  { id: "plate", text: plate },
];
