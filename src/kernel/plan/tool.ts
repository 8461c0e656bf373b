import type { Degrees, Length } from "../units.ts";

export const TOOL_TYPES = ["ROUGH", "FINISH", "RECESS", "RECTURN", "BUTTON", "THREAD"] as const;
export type ToolType = (typeof TOOL_TYPES)[number];
/** Tools on the axis that cut a bore of their own shape; they are stored in the table of milling tools. */
export const DRILL_TYPES = ["DRILL", "CENTER", "TAP", "REAM"] as const;
export type DrillType = (typeof DRILL_TYPES)[number];
/** Forms of centre holes: A plain, B with a protecting cone of 120°, R with a curved flank. */
export const CENTRE_FORMS = ["A", "B", "R"] as const;
export type CentreForm = (typeof CENTRE_FORMS)[number];

/** A centre hole of ISO 6411 or DIN 332-1, diameters and depths in mm. */
export interface CentreHole {
  readonly form: CentreForm;
  /** Pilot, and mouth of the cone of 60°. */
  readonly d1: number;
  readonly d2: number;
  /** Mouth of the protecting cone of 120°; that of the whole hole. */
  readonly d3: number;
  /** Least depth from the face to the end of the pilot. */
  readonly t: number;
  /** Shaft diameters that it is a guide value for: above the first, up to the second. */
  readonly over: number;
  readonly upTo: number;
}

/** A centre drill: the hole it is made for, and the length of its pilot from the point to the cone, mm. */
export interface CentreDrill {
  readonly hole: CentreHole;
  readonly pilot: Length;
}

/**
 * Height of the tooth of a thread insert whose CUTLENGTH is empty, mm: that of the usual insert for pitches from 0.5 to
 * 3 mm.
 */
export const USUAL_TOOTH = 2.5;

/** Tip orientation 1..9, as on HEIDENHAIN lathes. */
export type TipOrientation = 1 | 2 | 3 | 4 | 5 | 6 | 7 | 8 | 9;

/** What stands below the insert of a blade: nothing, a straight web, or one curved for axial grooves. */
export const BLADE_SUPPORTS = ["NONE", "STRAIGHT", "CURVED"] as const;
export type BladeSupport = (typeof BLADE_SUPPORTS)[number];

/** A corner of a holder, from the theoretical tip along Z and X (radius), mm. */
export type HolderCorner = readonly [z: Length, x: Length];

/**
 * A holder for the collision check only: it never changes a path. A box for the shank, and the parts between shank and
 * insert. All mm.
 */
export interface Holder {
  /** Across the shank. */
  readonly width: Length;
  /** Along the shank. */
  readonly length: Length;
  /** From the theoretical tip to the near corner of the shank, along Z and X (radius). */
  readonly offsetZ: Length;
  readonly offsetX: Length;
  /** Axis of the shank; default X for orientations that point to −X (and for round inserts), Z for all others. */
  readonly axis?: "X" | "Z";
  /** Head, neck or blade between shank and insert: convex outlines by their corners. */
  readonly head?: readonly (readonly HolderCorner[])[];
}

/**
 * One row of the turning-tool table, or a drill, by the names of its columns. mm and degrees; a missing cell is absent.
 */
export interface Tool {
  readonly T: number;
  readonly NAME: string;
  readonly TYPE: ToolType | DrillType;
  readonly TO: TipOrientation;
  readonly RS: Length;
  /** Radius of a drill, with its delta. */
  readonly R?: Length;
  /** Shape of a centre drill whose name states its hole. */
  readonly centre?: CentreDrill;
  /** Pitch of a tap. */
  readonly PITCH?: Length;
  readonly ZL?: Length;
  readonly XL?: Length;
  readonly DZL?: Length;
  readonly DXL?: Length;
  /** Oversize of length 3, along Y, perpendicular to the turning plane. */
  readonly DYL?: Length;
  readonly DRS?: Length;
  readonly ORI?: Degrees;
  readonly "T-ANGLE"?: Degrees;
  readonly "P-ANGLE"?: Degrees;
  readonly CUTLENGTH?: Length;
  readonly CUTWIDTH?: Length;
  readonly DCW?: Length;
  readonly holder?: Holder;
  /** What the maker of a blade or a bar states about its use, by the symbols of ISO 13399; mm, diameters. */
  /** Axial groove: smallest and largest outside diameter of the first plunge. */
  readonly DAXN?: Length;
  readonly DAXX?: Length;
  /** Greatest cutting depth of a blade. */
  readonly CDX?: Length;
  /** Largest diameter that a blade parts off. */
  readonly CUTDIA?: Length;
  /** Smallest bore for a boring bar. */
  readonly DMIN?: Length;
  readonly SUPPORT?: BladeSupport;
  /**
   * FUNCTION TURNDATA CORR: offset of the insert from the tip that the control calculates with, along Z and X (radius).
   */
  readonly correction?: { readonly z: Length; readonly r: Length };
}
