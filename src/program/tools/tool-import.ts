import type { CellName } from "./tool-columns.ts";
import { cellOf, isMillEntry, readEntry, type TableLine, type ToolEntry } from "./tool-entry.ts";
import { mergedTools, type ToolList } from "./tool-list.ts";

/** Rows of one or more files to be imported. */
export interface IncomingTools {
  readonly rows: readonly ToolEntry["cells"][];
  /** Source line of each row in a table of the control. */
  readonly lines: readonly (TableLine | undefined)[];
  /** Cells with a column in the file of each row; undefined for all. */
  readonly columns: readonly (readonly CellName[] | undefined)[];
  /** Names of turning tools in a milling table, by number. */
  readonly names: ReadonlyMap<number, string>;
}

/** Changes of one tool by a file. */
export interface ImportChange {
  readonly tool: ToolEntry;
  readonly cells: readonly { readonly cell: CellName; readonly from: string; readonly to: string }[];
}

/** Effect of an import. */
export interface ImportPlan {
  readonly fresh: readonly ToolEntry[];
  readonly changed: readonly ImportChange[];
  /** Number of unchanged tools. */
  readonly same: number;
  /** Imported tools with an error. */
  readonly wrong: readonly ToolEntry[];
  /** The table afterwards. */
  readonly list: ToolList;
}

/** A turning tool without a name takes its name from the milling table. */
function withNames(list: ToolList, names: IncomingTools["names"]): ToolList {
  if (names.size === 0) return list;
  return list.map((entry) => {
    if (isMillEntry(entry) || cellOf(entry, "NAME").trim() !== "") return entry;
    const name = names.get(readEntry(entry).number ?? NaN);
    return name ? { ...entry, cells: { ...entry.cells, NAME: name } } : entry;
  });
}

function differencesOf(before: ToolEntry, after: ToolEntry): ImportChange["cells"] {
  const cells = [...new Set([...Object.keys(before.cells), ...Object.keys(after.cells)])] as CellName[];
  return cells
    .map((cell) => ({ cell, from: cellOf(before, cell).trim(), to: cellOf(after, cell).trim() }))
    .filter(
      ({ from, to }) =>
        from !== to && !(from !== "" && to !== "" && Number(from.replace(",", ".")) === Number(to.replace(",", "."))),
    );
}

const isSound = (entry: ToolEntry) => {
  const { tool, mill } = readEntry(entry);
  return tool !== null || mill !== null;
};

/** Rows with a new number. */
function onlyNew(list: ToolList, { rows, lines, columns, names }: IncomingTools): IncomingTools {
  const taken = new Set(list.map((entry) => readEntry(entry).number));
  const at = rows.flatMap((cells, i) => (taken.has(readEntry({ id: "", cells }).number) ? [] : [i]));
  const kept = <T>(all: readonly T[]) => at.map((i) => all[i] as T);
  return { rows: kept(rows), lines: kept(lines), columns: kept(columns), names };
}

/** A tool keeps the cells without a column in the file, in most files those of the holder. */
function completed(list: ToolList, { rows, columns }: IncomingTools): IncomingTools["rows"] {
  const known = new Map(list.map((entry) => [readEntry(entry).number, entry]));
  return rows.map((cells, i) => {
    const [old, has] = [known.get(readEntry({ id: "", cells }).number), columns[i]];
    if (!old || !has || isMillEntry(old) !== isMillEntry({ id: "", cells })) return cells;
    const kept = Object.entries(old.cells).filter(([cell]) => cell !== "TYPE" && !has.some((each) => each === cell));
    return { ...Object.fromEntries(kept), ...cells };
  });
}

/** Plans an import: all rows, or those with new numbers only. */
export function planImport(list: ToolList, incoming: IncomingTools, choice: "all" | "new"): ImportPlan {
  const wanted = choice === "new" ? onlyNew(list, incoming) : incoming;
  const merged = mergedTools(list, completed(list, wanted), wanted.lines).list;
  const made = choice === "new" ? merged : withNames(merged, wanted.names);
  const before = new Map(list.map((entry) => [entry.id, entry]));
  const fresh = made.filter((entry) => !before.has(entry.id));
  const pairs = made.flatMap((entry) => {
    const old = before.get(entry.id);
    return old && old !== entry ? [{ tool: entry, cells: differencesOf(old, entry) }] : [];
  });
  const changed = pairs.filter(({ cells }) => cells.length > 0);
  const touched = [...fresh, ...pairs.map(({ tool }) => tool)];
  return {
    fresh,
    changed,
    same: pairs.length - changed.length,
    wrong: touched.filter((entry) => !isSound(entry)),
    list: made,
  };
}
