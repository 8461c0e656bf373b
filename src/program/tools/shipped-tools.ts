import type { TipOrientation, Tool, ToolType } from "../../kernel/plan/tool.ts";
import { degrees, length } from "../../kernel/units.ts";
import { shippedHolders } from "./shipped-holders.ts";

interface Columns {
  readonly angles?: readonly [tAngle: number, pAngle: number];
  readonly point?: number;
  readonly width?: number;
  readonly cut?: number;
}

const tool = (T: number, NAME: string, TYPE: ToolType, TO: TipOrientation, RS: number, c: Columns): Tool => ({
  T,
  NAME,
  TYPE,
  TO,
  RS: length(RS),
  ...(c.angles && { "T-ANGLE": degrees(c.angles[0]), "P-ANGLE": degrees(c.angles[1]) }),
  ...(c.point !== undefined && { "P-ANGLE": degrees(c.point) }),
  ...(c.width !== undefined && { CUTWIDTH: length(c.width) }),
  ...(c.cut !== undefined && { CUTLENGTH: length(c.cut) }),
  ...(shippedHolders[T] && { holder: shippedHolders[T] }),
});

/** Default tools of every installation. Lengths mm, angles degrees. */
export const shippedTools: readonly Tool[] = [
  tool(1, "CNMG-80-R08", "ROUGH", 1, 0.8, { angles: [95, 80], cut: 12 }),
  tool(2, "DNMG-55-R08", "ROUGH", 1, 0.8, { angles: [93, 55], cut: 12 }),
  tool(3, "DNMG-55-R04", "FINISH", 1, 0.4, { angles: [93, 55], cut: 12 }),
  tool(4, "VNMG-35-R04", "FINISH", 1, 0.4, { angles: [93, 35], cut: 16 }),
  tool(5, "BORE-CCMT-80-R04", "ROUGH", 7, 0.4, { angles: [95, 80], cut: 9 }),
  tool(6, "BORE-DCMT-55-R04", "FINISH", 7, 0.4, { angles: [93, 55], cut: 9 }),
  tool(7, "LEFT-DNMG-55-R08", "ROUGH", 3, 0.8, { angles: [93, 55], cut: 12 }),
  tool(8, "FACE-RECTURN-3", "RECTURN", 8, 0.2, { width: 3, cut: 35 }),
  tool(9, "OD-RECTURN-3", "RECTURN", 2, 0.2, { width: 3, cut: 30 }),
  tool(10, "OD-RECESS-2", "RECESS", 2, 0.1, { width: 2, cut: 20 }),
  tool(11, "BUTTON-R3", "BUTTON", 2, 3, {}),
  tool(12, "THREAD-60-OD", "THREAD", 2, 0.1, { point: 60, cut: 2.5 }),
  tool(13, "THREAD-60-ID", "THREAD", 6, 0.1, { point: 60, cut: 2.5 }),
  tool(14, "ID-RECTURN-2", "RECTURN", 6, 0.2, { width: 2, cut: 12 }),
  tool(15, "FACE-DNMG-55-R08", "ROUGH", 1, 0.8, { angles: [120, 55], cut: 12 }),
];
