import { helpSvg } from "../help/svg.ts";
import type { ApproachDrawing } from "./drawing.ts";

/**
 * A picture of an approach as a text of its own, one element a line, for goldens. Colours belong to the page's style
 * sheet.
 */
export const approachSvg = ({ size, marks }: ApproachDrawing): string => helpSvg({ size, marks, labels: [] });
