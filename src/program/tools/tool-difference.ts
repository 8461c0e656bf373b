import { BESIDE_CELLS, MILL_COLUMNS, TOOL_COLUMNS, type CellName } from "./tool-columns.ts";
import { cellOf, readEntry, type ToolEntry } from "./tool-entry.ts";
import { freeNumber, newId, type ToolList } from "./tool-list.ts";

/** An incoming row, and the existing row with its number; null where the number is free. */
export interface ToolPair {
  readonly entry: ToolEntry;
  readonly number: number | null;
  readonly mine: ToolEntry | null;
  /** Differing cells, in the order of the table. */
  readonly differs: readonly CellName[];
}

const CELLS: readonly CellName[] = [...new Set<CellName>([...TOOL_COLUMNS, ...MILL_COLUMNS, ...BESIDE_CELLS])];

/** Normalized text of a cell: `0,80` is 0.8. */
function normalizedCell(entry: ToolEntry, cell: CellName): string {
  const text = cellOf(entry, cell).trim();
  const number = Number(text.replace(",", "."));
  return text !== "" && Number.isFinite(number) ? String(number) : text;
}

/** Pairs each incoming row with the existing row of its number. */
export function pairTools(theirs: ToolList, mine: ToolList): readonly ToolPair[] {
  const byNumber = new Map<number, ToolEntry>();
  for (const entry of mine) {
    const { number } = readEntry(entry);
    if (number !== null && !byNumber.has(number)) byNumber.set(number, entry);
  }
  return theirs.map((entry) => {
    const { number } = readEntry(entry);
    const other = number === null ? undefined : byNumber.get(number);
    const differs = other ? CELLS.filter((cell) => normalizedCell(entry, cell) !== normalizedCell(other, cell)) : [];
    return { entry, number, mine: other ?? null, differs };
  });
}

/** What to do with an incoming row whose number is another tool here. */
export type KeepAs = "mine" | "theirs" | "free";

/** The merged rows, and the numbers that changed. */
export interface KeptTools {
  readonly list: ToolList;
  readonly added: number;
  readonly replaced: number;
  readonly moved: readonly { readonly from: number; readonly to: number }[];
}

/** Adds incoming rows to a table: at their own numbers where free, else as chosen. */
export function keepTools(mine: ToolList, theirs: ToolList, choice: (beside: ToolPair) => KeepAs): KeptTools {
  let list = mine;
  let [added, replaced] = [0, 0];
  const moved: { from: number; to: number }[] = [];
  const add = (cells: ToolEntry["cells"]) => {
    list = [...list, { id: newId(list), cells }];
    added++;
  };
  for (const beside of pairTools(theirs, mine)) {
    const { entry, number, mine: other, differs } = beside;
    if (!other) add(entry.cells);
    else if (differs.length === 0 || number === null) continue;
    else if (choice(beside) === "theirs") {
      list = list.map((row) => (row === other ? { id: other.id, cells: entry.cells } : row));
      replaced++;
    } else if (choice(beside) === "free") {
      // A number used by the job itself is not free for another of its tools.
      const to = freeNumber([...list, ...theirs]);
      add({ ...entry.cells, T: String(to) });
      moved.push({ from: number, to });
    }
  }
  return { list, added, replaced, moved };
}

/** Renumbers tool rows of a job. */
export const renumberedTools = (list: ToolList, moved: KeptTools["moved"]): ToolList =>
  list.map((entry) => {
    const found = moved.find(({ from }) => from === readEntry(entry).number);
    return found ? { ...entry, cells: { ...entry.cells, T: String(found.to) } } : entry;
  });
