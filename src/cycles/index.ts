import { c800 } from "./c800.ts";
import { c801 } from "./c801.ts";
import { c810 } from "./c810.ts";
import { c811 } from "./c811.ts";
import { c812 } from "./c812.ts";
import { c813 } from "./c813.ts";
import { c814 } from "./c814.ts";
import { c815 } from "./c815.ts";
import { c820 } from "./c820.ts";
import { c821 } from "./c821.ts";
import { c822 } from "./c822.ts";
import { c823 } from "./c823.ts";
import { c824 } from "./c824.ts";
import { c830 } from "./c830.ts";
import { c831 } from "./c831.ts";
import { c832 } from "./c832.ts";
import { c840 } from "./c840.ts";
import { c841 } from "./c841.ts";
import { c842 } from "./c842.ts";
import { c850 } from "./c850.ts";
import { c851 } from "./c851.ts";
import { c852 } from "./c852.ts";
import { c860 } from "./c860.ts";
import { c861 } from "./c861.ts";
import { c862 } from "./c862.ts";
import { c870 } from "./c870.ts";
import { c871 } from "./c871.ts";
import { c872 } from "./c872.ts";
import type { Cycle } from "./define.ts";
import type { Param, Params } from "./params.ts";

/** In menu order. A new cycle is one file and one entry here. */
const list = [
  c800,
  c801,
  c810,
  c811,
  c812,
  c813,
  c814,
  c815,
  c820,
  c821,
  c822,
  c823,
  c824,
  c830,
  c831,
  c832,
  c840,
  c841,
  c842,
  c850,
  c851,
  c852,
  c860,
  c861,
  c862,
  c870,
  c871,
  c872,
] as const;
type Listed = (typeof list)[number];

/** All cycles in menu order. */
export const catalogue: readonly Cycle[] = list;

/** Cycles that cut. The others act where a program defines them. */
export const cuttingCycles: readonly Cycle[] = catalogue.filter((c) => !c.acts);
/** Cycles that act where they are defined. */
export const actingCycles: readonly Cycle[] = catalogue.filter((c) => c.acts);

/** The numbers of the catalogue: a cycle without texts is a compile error. */
export type CycleNumber = Listed["number"];

/** Every text key of a parameter in the catalogue: a key without texts is a compile error. */
export type ParamTextId = { [N in CycleNumber]: TextOf<Extract<Listed, { number: N }>["params"]> }[CycleNumber];

/** The keys of choices: their texts explain each choice. */
export type ChoiceTextId = { [N in CycleNumber]: ChoiceTextOf<Extract<Listed, { number: N }>["params"]> }[CycleNumber];
type ChoiceTextOf<P extends Params> = { [Q in keyof P]: P[Q] extends Param<"choice", infer T> ? T : never }[keyof P];
type TextOf<P extends Params> = P[keyof P]["text"];

/** The cycle of a number; undefined when the catalogue does not have it. */
export const cycleByNumber = (number: number): Cycle | undefined => catalogue.find((c) => c.number === number);
