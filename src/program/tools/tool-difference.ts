import { HOLDER_CELLS, MILL_COLUMNS, TOOL_COLUMNS, type CellName } from "./tool-columns.ts";
import { cellOf, readEntry, type ToolEntry } from "./tool-entry.ts";
import { freeNumber, newId, type ToolList } from "./tool-list.ts";

/** A row that comes from elsewhere, beside the row that has its number here; null where the number is free. */
export interface ToolBeside {
  readonly entry: ToolEntry;
  readonly number: number | null;
  readonly mine: ToolEntry | null;
  /** Cells that say something else here, in the order of the table. */
  readonly differs: readonly CellName[];
}

const CELLS: readonly CellName[] = [...new Set<CellName>([...TOOL_COLUMNS, ...MILL_COLUMNS, ...HOLDER_CELLS])];

/** A cell as it counts: `0,80` is 0.8. */
function meant(entry: ToolEntry, cell: CellName): string {
  const text = cellOf(entry, cell).trim();
  const number = Number(text.replace(",", "."));
  return text !== "" && Number.isFinite(number) ? String(number) : text;
}

/** The rows of a table that came from elsewhere, each beside the row of its number in another one. */
export function toolsBeside(theirs: ToolList, mine: ToolList): readonly ToolBeside[] {
  const byNumber = new Map<number, ToolEntry>();
  for (const entry of mine) {
    const { number } = readEntry(entry);
    if (number !== null && !byNumber.has(number)) byNumber.set(number, entry);
  }
  return theirs.map((entry) => {
    const { number } = readEntry(entry);
    const other = number === null ? undefined : byNumber.get(number);
    const differs = other ? CELLS.filter((cell) => meant(entry, cell) !== meant(other, cell)) : [];
    return { entry, number, mine: other ?? null, differs };
  });
}

/** What becomes of a row whose number stands for another tool here. */
export type KeepAs = "mine" | "theirs" | "free";

/** Rows kept beside those of a table, and the numbers that they had to give up for others. */
export interface KeptTools {
  readonly list: ToolList;
  readonly added: number;
  readonly replaced: number;
  readonly moved: readonly { readonly from: number; readonly to: number }[];
}

/** Keeps rows beside those of a table: at their numbers where these are free, as it was chosen where they are not. */
export function keptBeside(mine: ToolList, theirs: ToolList, choice: (beside: ToolBeside) => KeepAs): KeptTools {
  let list = mine;
  let [added, replaced] = [0, 0];
  const moved: { from: number; to: number }[] = [];
  const add = (cells: ToolEntry["cells"]) => {
    list = [...list, { id: newId(list), cells }];
    added++;
  };
  for (const beside of toolsBeside(theirs, mine)) {
    const { entry, number, mine: other, differs } = beside;
    if (!other) add(entry.cells);
    else if (differs.length === 0 || number === null) continue;
    else if (choice(beside) === "theirs") {
      list = list.map((row) => (row === other ? { id: other.id, cells: entry.cells } : row));
      replaced++;
    } else if (choice(beside) === "free") {
      // A number that the work itself uses is not free for another of its tools.
      const to = freeNumber([...list, ...theirs]);
      add({ ...entry.cells, T: String(to) });
      moved.push({ from: number, to });
    }
  }
  return { list, added, replaced, moved };
}

/** Rows of a work with other numbers in place of some. */
export const renumberedTools = (list: ToolList, moved: KeptTools["moved"]): ToolList =>
  list.map((entry) => {
    const found = moved.find(({ from }) => from === readEntry(entry).number);
    return found ? { ...entry, cells: { ...entry.cells, T: String(found.to) } } : entry;
  });
