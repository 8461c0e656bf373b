import { acting, kept, menu } from "virtual:cycle-menu";
import type { Group } from "../../../cycles/define.ts";
import type { Pictogram } from "../../../view/pictogram-box.ts";

/** Cycle data that is available before the catalogue is loaded. */
export interface MenuCycle {
  readonly number: number;
  readonly group: Group;
  /** Its contour is a subprogram. */
  readonly free: boolean;
  /** Its parameter list is not verified against a manual. */
  readonly recalled: boolean;
  /** Pictograms of its example, outside and, where possible, inside. */
  readonly pictograms: readonly Pictogram[];
}

/** In the order of the control. */
const GROUPS: readonly Group[] = ["special", "longitudinal", "transverse", "recessTurning", "recessing", "thread"];

/** Cycles that can start a work, or be inserted into a program; only the latter include DEF-active cycles. */
export const offeredCycles = (inProgram: boolean): readonly MenuCycle[] => (inProgram ? [...acting, ...menu] : menu);

/** The groups that have a cycle, with their cycles in menu order. */
export const menuGroups = (cycles: readonly MenuCycle[]): readonly (readonly [Group, readonly MenuCycle[]])[] =>
  GROUPS.map((group) => [group, cycles.filter((cycle) => cycle.group === group)] as const).filter(
    ([, own]) => own.length > 0,
  );

/** A cycle that cannot be chosen here, with the reason: DEF-active, or not simulated. */
export interface UnofferedCycle {
  readonly number: number;
  readonly why: "acts" | "kept";
}

export const unofferedCycles = (inProgram: boolean): readonly UnofferedCycle[] => [
  ...(inProgram ? [] : acting.map(({ number }) => ({ number, why: "acts" as const }))),
  ...kept.map((number) => ({ number, why: "kept" as const })),
];

/** The cycle of a number; undefined when the catalogue does not have it. */
export const menuCycle = (number: number): MenuCycle | undefined => menu.find((cycle) => cycle.number === number);
