import type { Tool } from "../../kernel/plan/tool.ts";
import type { Spindle } from "../../kernel/time/step.ts";
import type { SpindleData } from "../../program/machine/machine-data.ts";
import type { CutMaterial } from "../../program/tools/cutting-table.ts";
import type { ReasonedNumber } from "./formulas.ts";
import type { HeldBar, HeldWorkpiece } from "../../report/advice/stability.ts";

/** Kinds of work that have values of their own. */
export type Work = "rough" | "face" | "finish" | "recess" | "partOff" | "thread" | "drill" | "centre" | "ream";

/** A wanted surface, µm. */
export interface WantedRoughness {
  readonly kind: "Ra" | "Rz";
  readonly value: number;
}

/** What the values of a cut are made from. Lengths mm. */
export interface ValuesRequest {
  readonly work: Work;
  readonly tool: Tool;
  readonly material: CutMaterial;
  /** Smallest and largest diameter that is cut. */
  readonly smallest: number;
  readonly largest: number;
  /** Null: not known, so that nothing is limited by it. */
  readonly workpiece: HeldWorkpiece | null;
  /** The boring bar of an inside cut; null outside, or where its overhang is not known. */
  readonly bar: HeldBar | null;
  readonly machine: SpindleData | null;
  /** Power of the shop's cutting data where the machine states none, kW. */
  readonly power: number;
  readonly roughness: WantedRoughness | null;
  /** Depth of a hole or a groove, height of a thread. */
  readonly depth?: number;
  /** Pitch of a thread. */
  readonly pitch?: number;
  /** Fastest feed of the machine along the thread, mm/min. */
  readonly fastest?: number | null;
}

/** Something that needs attention beside the values: length over diameter of workpiece or bar, depth over width. */
export interface ValueRisk {
  readonly kind: "slenderWorkpiece" | "slenderBar" | "deepGroove" | "notDrilled" | "edgeUnknown";
  readonly ratio: number;
}

/** Values of a cut, each with its formula; null where the work has none. */
export interface CuttingValues {
  /** Depth of a pass, per side; first pass of a thread. */
  readonly infeed: ReasonedNumber | null;
  /** mm/rev */
  readonly feed: ReasonedNumber;
  /** Feed into solid material, mm/rev. */
  readonly plungeFeed: ReasonedNumber | null;
  /** Depth after which a plunge or a drill breaks the chip. */
  readonly step: ReasonedNumber | null;
  /** Cutting speed in m/min, or rpm of a constant spindle. */
  readonly speed: ReasonedNumber;
  /** Speed limit of a constant cutting speed, rpm; null with a constant spindle. */
  readonly limit: ReasonedNumber | null;
  readonly spindle: Spindle;
  /** Oversize that suits the finishing tool: on the diameter, and along Z. */
  readonly oversize: { readonly diameter: ReasonedNumber; readonly z: ReasonedNumber } | null;
  readonly risks: readonly ValueRisk[];
}
