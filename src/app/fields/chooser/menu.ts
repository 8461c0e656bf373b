import { acting, kept, menu } from "virtual:cycle-menu";
import type { Group } from "../../../cycles/define.ts";
import type { Pictogram } from "../../../view/pictogram-box.ts";

/** What the page knows of a cycle while the catalogue is not here. */
export interface MenuCycle {
  readonly number: number;
  readonly group: Group;
  /** Its contour is a subprogram. */
  readonly free: boolean;
  /** No page that we hold prints its list of parameters. */
  readonly recalled: boolean;
  /** What it makes of its example, outside and, where it can, inside. */
  readonly pictograms: readonly Pictogram[];
}

/** As the control shows them. */
const GROUPS: readonly Group[] = ["special", "longitudinal", "transverse", "recessTurning", "recessing", "thread"];

/**
 * The cycles that can be chosen: to begin a work, or to be put into a program, where those that act there are offered
 * too.
 */
export const offered = (inProgram: boolean): readonly MenuCycle[] => (inProgram ? [...acting, ...menu] : menu);

/** The groups that have a cycle, with their cycles in menu order. */
export const menuGroups = (cycles: readonly MenuCycle[]): readonly (readonly [Group, readonly MenuCycle[]])[] =>
  GROUPS.map((group) => [group, cycles.filter((cycle) => cycle.group === group)] as const).filter(
    ([, own]) => own.length > 0,
  );

/** A cycle of the control that cannot be chosen here, and why: it acts in a program, or is kept in one and not run. */
export interface Elsewhere {
  readonly number: number;
  readonly why: "acts" | "kept";
}

export const notHere = (inProgram: boolean): readonly Elsewhere[] => [
  ...(inProgram ? [] : acting.map(({ number }) => ({ number, why: "acts" as const }))),
  ...kept.map((number) => ({ number, why: "kept" as const })),
];

/** The cycle of a number; undefined when the catalogue does not have it. */
export const menuCycle = (number: number): MenuCycle | undefined => menu.find((cycle) => cycle.number === number);
