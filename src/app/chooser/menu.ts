import { menu } from "virtual:cycle-menu";
import type { Group } from "../../cycles/define.ts";
import type { Pictogram } from "../../view/pictogram-box.ts";

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

/** The groups that have a cycle, with their cycles in menu order. */
export const menuGroups: readonly (readonly [Group, readonly MenuCycle[]])[] = GROUPS.map((group) =>
  [group, menu.filter((cycle) => cycle.group === group)] as const
).filter(([, cycles]) => cycles.length > 0);

/** The cycle of a number; undefined when the catalogue does not have it. */
export const menuCycle = (number: number): MenuCycle | undefined => menu.find((cycle) => cycle.number === number);
