import { withoutAccents } from "../../app/fields/chooser/search.ts";
import type { WorkSummary } from "../../app/records/device.ts";

/** Orders of the list of works. */
export const WORK_ORDERS = ["newest", "name", "kind", "size"] as const;
export type WorkOrder = (typeof WORK_ORDERS)[number];

const byTime = (a: WorkSummary, b: WorkSummary) => b.savedAt - a.savedAt;

/**
 * The works whose name or cycle contains every search word, sorted. `cycleName` gives the name of a cycle on the
 * screen.
 */
export function listWorks(
  works: readonly WorkSummary[],
  sought: string,
  order: WorkOrder,
  cycleName: (cycle: number) => string,
): readonly WorkSummary[] {
  const words = withoutAccents(sought)
    .split(/[\s,;]+/)
    .filter((word) => word !== "");
  const textOf = ({ name, cycle }: WorkSummary) =>
    withoutAccents(`${name} ${cycle === null ? ".h" : `${cycle} ${cycleName(cycle)}`}`);
  const found =
    words.length === 0
      ? [...works]
      : works.filter((work) => {
          const text = textOf(work);
          return words.every((word) => text.includes(word));
        });
  // Natural order: A2 before A10.
  const { compare } = new Intl.Collator("en", { numeric: true, sensitivity: "base" });
  const orders: Readonly<Record<WorkOrder, (a: WorkSummary, b: WorkSummary) => number>> = {
    newest: byTime,
    name: (a, b) => compare(a.name, b.name) || byTime(a, b),
    kind: (a, b) => (a.cycle ?? -1) - (b.cycle ?? -1) || compare(a.name, b.name),
    size: (a, b) => b.size - a.size || compare(a.name, b.name),
  };
  return found.sort(orders[order]);
}
