import { isBar } from "../../kernel/cutter/insert.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { radians } from "../../kernel/units.ts";

/*
 * Rules of thumb as plain formulas (sources: decision 0032). The results are estimates, without insert coating and
 * machine. Lengths mm, feeds mm/rev, speeds m/min, forces N, power kW.
 */

/** Kienzle coefficients of a material: force for 1 mm² of a chip 1 mm thick, N/mm², and its increase for thin chips. */
export interface Kienzle {
  readonly kc11: number;
  readonly mc: number;
}

/** Millimetres in a metre; seconds in a minute times watts in a kilowatt. */
const MM = 1000;
const PER_MINUTE = 60_000;
const right = Math.PI / 2;

/** The diameter below which a limited spindle no longer holds its cutting speed. */
export const heldDownTo = (speed: number, limit: number): number => (MM * speed) / (Math.PI * limit);

/** Specific cutting force at a chip thickness, N/mm²: kc = kc1.1 · h^−mc. */
export const specificForce = ({ kc11, mc }: Kienzle, thickness: number): number => kc11 * thickness ** -mc;

/**
 * Force along the cut, N: depth times feed times the specific force at h = f · sin κ. `lead`: angle of the edge to the
 * path, rad.
 */
export const cuttingForce = (of: Kienzle, depth: number, feed: number, lead = right): number =>
  depth * feed * specificForce(of, feed * Math.sin(lead));

/** Power at the spindle, kW: Pc = Fc · vc / 60 000. */
export const cuttingPower = (of: Kienzle, depth: number, feed: number, speed: number, lead = right): number =>
  (cuttingForce(of, depth, feed, lead) * speed) / PER_MINUTE;

/** The depth of cut that uses the available power. */
export const depthForPower = (of: Kienzle, power: number, feed: number, speed: number, lead = right): number =>
  power / cuttingPower(of, 1, feed, speed, lead);

/** The feed for a theoretical roughness, µm, with a nose radius: Rz = f² / 8r. */
export const feedForRz = (rz: number, nose: number): number => Math.sqrt((8 * nose * rz) / MM);

/** Greatest roughing feed as a share of the nose radius, and greatest engaged share of the edge. */
export const FEED_OF_NOSE = 0.8;
export const EDGE_USED = 2 / 3;
/** Theoretical roughness that is usual for a finished surface, µm. */
export const USUAL_RZ = 6.3;
/** Default angle between edge and path, degrees, where the tool table has none. */
const LEAD = 90;
/** Angle of the main edge to the path, rad. */
export const leadOf = (tool: Tool): number => radians(isBar(tool) ? LEAD : (tool["T-ANGLE"] ?? LEAD));
