import { readJson } from "../files/bounded.ts";
import { z } from "zod/mini";

/** Groups of ISO 513: steel, stainless steel, cast iron, non-ferrous, hard to cut, hardened. */
export const ISO_GROUPS = ["P", "M", "K", "N", "S", "H"] as const;
export type IsoGroup = (typeof ISO_GROUPS)[number];

/**
 * A material with its starting values for coated carbide, hardened steel for CBN, turned dry or wet on a sound machine.
 */
export interface CutMaterial {
  readonly id: string;
  /** As it is written on a drawing. */
  readonly name: string;
  readonly group: IsoGroup;
  /** Kienzle: N/mm², and the exponent of chip thickness. */
  readonly kc11: number;
  readonly mc: number;
  /** m/min and mm/rev. */
  readonly roughSpeed: number;
  readonly roughFeed: number;
  readonly finishSpeed: number;
  readonly finishFeed: number;
}

/** Cutting data of a shop. */
export interface CuttingTable {
  /** Power of the spindle, kW. */
  readonly power: number;
  readonly materials: readonly CutMaterial[];
}

type Row = readonly [
  id: string,
  name: string,
  group: IsoGroup,
  kc11: number,
  mc: number,
  roughSpeed: number,
  roughFeed: number,
  finishSpeed: number,
  finishFeed: number,
];

/** Values of makers' tables, rounded; docs/decisions/0032 has each with its source. */
const ROWS: readonly Row[] = [
  ["s235", "S235JR (1.0038)", "P", 1780, 0.17, 220, 0.3, 280, 0.15],
  ["c45", "C45E (1.1191)", "P", 2220, 0.14, 190, 0.3, 250, 0.15],
  ["16mncr5", "16MnCr5 (1.7131)", "P", 2100, 0.26, 200, 0.3, 260, 0.15],
  ["42crmo4", "42CrMo4 (1.7225)", "P", 2500, 0.26, 160, 0.28, 210, 0.14],
  ["x5crni", "X5CrNi18-10 (1.4301)", "M", 2150, 0.2, 130, 0.25, 170, 0.12],
  ["x2crnimo", "X2CrNiMo17-12-2 (1.4404)", "M", 2150, 0.2, 120, 0.25, 160, 0.12],
  ["gjl250", "EN-GJL-250 (5.1301)", "K", 1160, 0.26, 180, 0.35, 240, 0.18],
  ["gjs600", "EN-GJS-600-3 (5.3201)", "K", 1350, 0.28, 150, 0.3, 200, 0.15],
  // 8e2, since the plain number is also a cycle number
  ["almgsi", "EN AW-6082 (AlMgSi1)", "N", 8e2, 0.25, 400, 0.35, 600, 0.15],
  ["brass", "CuZn39Pb3 (CW614N)", "N", 700, 0.27, 300, 0.3, 400, 0.12],
  ["tial6v4", "TiAl6V4 (3.7165)", "S", 1245, 0.24, 50, 0.2, 65, 0.1],
  ["alloy718", "Alloy 718 (2.4668)", "S", 3300, 0.24, 35, 0.2, 45, 0.1],
  ["100cr6", "100Cr6, 60 HRC (1.3505)", "H", 4700, 0.25, 110, 0.12, 150, 0.08],
];

/** The shipped table: starting values, to be replaced by those of the shop. */
export const usualTable: CuttingTable = {
  power: 11,
  materials: ROWS.map(([id, name, group, kc11, mc, roughSpeed, roughFeed, finishSpeed, finishFeed]) => ({
    id,
    name,
    group,
    kc11,
    mc,
    roughSpeed,
    roughFeed,
    finishSpeed,
    finishFeed,
  })),
};

/** Most materials of a table, and the longest name. */
const MOST = 100;
const LONGEST = 80;
const between = (low: number, high: number) => z.number().check(z.gte(low), z.lte(high));
const name = z.string().check(z.minLength(1), z.maxLength(LONGEST));
const shape = z.object({
  power: between(0.1, 500),
  materials: z
    .array(
      z.object({
        id: name,
        name,
        group: z.enum(ISO_GROUPS),
        kc11: between(100, 20_000),
        mc: between(0, 0.9),
        roughSpeed: between(1, 5000),
        roughFeed: between(0.01, 5),
        finishSpeed: between(1, 5000),
        finishFeed: between(0.01, 5),
      }),
    )
    .check(z.minLength(1), z.maxLength(MOST)),
});

/** Reads a shop's table from text; null when invalid. Never throws. */
export function readCuttingTable(text: string): CuttingTable | null {
  try {
    const read = shape.safeParse(readJson(text));
    const ids = read.data?.materials.map(({ id }) => id) ?? [];
    return read.success && new Set(ids).size === ids.length ? read.data : null;
  } catch {
    return null;
  }
}

export const writeCuttingTable = (table: CuttingTable): string => JSON.stringify(table, null, 2);
