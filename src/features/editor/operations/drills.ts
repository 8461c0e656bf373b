import { useMemo } from "react";
import type { NamedThread } from "../../../kernel/thread/named-thread.ts";
import type { Tool } from "../../../kernel/plan/tool.ts";
import { drillOf } from "../../../program/tools/drill-of.ts";
import type { ShopTools } from "../../../program/tools/read-tools.ts";
import { isCoreDrill } from "../../../program/tools/tap-of-thread.ts";
import { standardDrills } from "../../../program/tools/standard-drills.ts";
import { standardReamers } from "../../../program/tools/standard-reamers.ts";
import { newId, readList, type ToolList } from "../../../program/tools/tool-list.ts";
import { addTool } from "../../../app/document/add-tool.ts";
import { bundleOf, useEditor } from "../../../app/document/store.ts";
import { toolsOnDevice, useTools } from "../../../app/document/tool-store.ts";
import { listInUse } from "../../../app/document/work-tools.ts";

/** Usual drills, taps and reamers with free numbers, those of a thread among them. */
const usualOnAxis = (list: ToolList, thread: NamedThread | null) => [
  ...standardDrills(list, thread),
  ...standardReamers(list),
];

/** Drills, taps and reamers of a table, as tools on the axis. */
const drillsIn = ({ mills = [] }: ShopTools): readonly Tool[] => mills.flatMap((row) => drillOf(row) ?? []);

/** Drills and taps of the open work; a standard one has its row, which is added when it is called. */
export interface Drills {
  readonly own: readonly Tool[];
  readonly standard: readonly Tool[];
}

/** The drills of the open work's table, and standard ones with free numbers, those of a thread among them; follows the work and the table. */
export function useDrills(thread: NamedThread | null): Drills {
  const shop = useTools((s) => s.list);
  const own = useEditor((s) => bundleOf(s).tools);
  return useMemo(() => {
    const list = own ?? shop;
    const rows = usualOnAxis(list, thread).map((cells, i) => ({ id: `standard ${i}`, cells }));
    return { own: drillsIn(toolsOnDevice(list).table), standard: drillsIn(readList(rows).table) };
  }, [own, shop, thread]);
}

/** The drill for the hole before a tap: one of the table, else a standard one. */
export function coreDrill(
  { own, standard }: Drills,
  thread: NamedThread,
): { readonly tool: Tool; readonly isStandard: boolean } | null {
  const tool = [...own, ...standard].find((each) => isCoreDrill(each, thread));
  return tool ? { tool, isStandard: !own.includes(tool) } : null;
}

type StandardRows = (list: ToolList) => readonly ToolList[number]["cells"][];

/** Turning tools of a standard list, with numbers that are free in the open work's table. */
export function useStandardTools(rowsOf: StandardRows): readonly Tool[] {
  const shop = useTools((s) => s.list);
  const own = useEditor((s) => bundleOf(s).tools);
  return useMemo(() => {
    const rows = rowsOf(own ?? shop).map((cells, i) => ({ id: `standard ${i}`, cells }));
    return readList(rows).table.tools;
  }, [own, shop, rowsOf]);
}

/** Adds a tool of a standard list to the table of the open work. */
export function addStandardTool(rowsOf: StandardRows, T: number): void {
  const list = listInUse();
  const cells = rowsOf(list).find((row) => Number(row.T) === T);
  if (!cells) return;
  addTool({ id: newId(list), cells });
}

/** Adds a standard drill, or a drill or tap of a thread, to the table of the open work. */
export const addStandardDrill = (T: number, thread: NamedThread | null): void =>
  addStandardTool((list) => usualOnAxis(list, thread), T);
