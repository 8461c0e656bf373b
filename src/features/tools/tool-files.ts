import type { ToolsTexts } from "../../i18n/en/tables/tools.ts";
import type { Language } from "../../i18n/languages.ts";
import { decimalSign } from "../../i18n/number.ts";
import type { ToolFileTexts } from "../../i18n/tool-file-text.ts";
import { writeBackTable } from "../../program/tools/table-write-back.ts";
import {
  cellOf,
  isMillEntry,
  tableOrigin,
  type EntryReading,
  type TableLine,
  type TableOrigin,
} from "../../program/tools/tool-entry.ts";
import { planImport, type IncomingTools } from "../../program/tools/tool-import.ts";
import { readSheet } from "../../program/tool-sheets/sheet.ts";
import { writeTableCsv } from "../../program/tools/tool-table-csv.ts";
import { readToolFile, writeTableJson } from "../../program/tools/tool-table-json.ts";
import { writeMillText, writeTableText } from "../../program/tools/tool-table-text.ts";
import { decode, encode } from "../../app/document/encoding.ts";
import { downloadBytes, downloadText } from "../../app/base/download.ts";
import { closeStep } from "../../app/document/steps.ts";
import { openToolRow } from "../../app/place/place.ts";
import { editTools, toolsOnDevice, useTools } from "../../app/document/tool-store.ts";
import { isWorkbook, sheetInFile, type NamedSheet } from "./sheet-files.ts";
import type { TableMessage } from "../../app/fields/table/TableStatus.tsx";

const failure = (sentence: string): TableMessage => ({ sentences: [sentence], failed: true, changed: false });

const isSound = (reading: EntryReading | undefined) => Boolean(reading?.tool ?? reading?.mill);

/** Contents of the import files, before they are applied to the table. */
export interface ToolImport {
  /** The names of the files. */
  readonly name: string;
  readonly incoming: IncomingTools;
  /** Unknown columns: those of control tables stay with the file, others are left out. */
  readonly kept: readonly string[];
  readonly leftOut: readonly string[];
  readonly cutShort: boolean;
  /** Sentences about how it was read, shown before it is applied. */
  readonly notes?: readonly string[];
  /** The sheet whose columns were assigned, so that they can be assigned again. */
  readonly sheet?: NamedSheet;
}

/** Larger files are no tool table, bytes. */
const LARGEST = 20_000_000;

/** Reads a file whose columns are known; null when it is none. */
function readImport(bytes: Uint8Array, name: string, t: ToolsTexts): ToolImport | TableMessage | null {
  const { text, encoding } = decode(bytes);
  const read = readToolFile(text);
  if ("problem" in read) {
    switch (read.problem) {
      case "columnsMissing":
        return failure(t.problems.columnsMissing(name, read.columns.join(", ")));
      case "tooMany":
        return failure(t.problems.tooMany(name, read.most));
      case "noRows":
        return failure(t.problems.noRows(name));
      case "notATable":
        return null;
    }
  }
  const { rows, table, columns, leftOut, cutShort } = read;
  const origin = tableOrigin(name, text, encoding);
  const lines = rows.map((_, i): TableLine | undefined => {
    const at = table?.lines[i];
    return at === undefined ? undefined : { origin, at };
  });
  const incoming = {
    rows,
    lines,
    columns: rows.map(() => columns),
    names: table?.turning ?? new Map<number, string>(),
  };
  // A sheet with further columns can have them assigned.
  const sheet = !table && leftOut.length > 0 ? readSheet(text) : null;
  return {
    name,
    incoming,
    kept: table ? leftOut : [],
    leftOut: table ? [] : leftOut,
    cutShort,
    ...(sheet && { sheet: { name, sheet } }),
  };
}

const joined = (all: readonly ToolImport[]): ToolImport => ({
  name: all.map((each) => each.name).join(", "),
  incoming: {
    rows: all.flatMap((each) => each.incoming.rows),
    lines: all.flatMap((each) => each.incoming.lines),
    columns: all.flatMap((each) => each.incoming.columns),
    names: new Map(all.flatMap((each) => [...each.incoming.names])),
  },
  kept: [...new Set(all.flatMap((each) => each.kept))],
  leftOut: [...new Set(all.flatMap((each) => each.leftOut))],
  cutShort: all.some((each) => each.cutShort),
  notes: all.flatMap((each) => each.notes ?? []),
  ...(all.length === 1 && all[0]?.sheet && { sheet: all[0].sheet }),
});

/** A file or what was pasted. */
export interface ImportSource {
  readonly name: string;
  readonly size: number;
  readonly arrayBuffer: () => Promise<ArrayBuffer>;
}

/**
 * Reads all chosen files, or returns the fault of the first one that cannot be read. The columns of a sheet with other
 * titles are assigned by `assign`; null when that was given up.
 */
export async function readImportFiles(
  files: readonly ImportSource[],
  t: ToolsTexts,
  w: ToolFileTexts,
  assign: (sheet: NamedSheet) => Promise<ToolImport | null>,
): Promise<ToolImport | TableMessage | null> {
  const all: ToolImport[] = [];
  for (const file of files) {
    if (file.size > LARGEST) return failure(t.problems.tooLarge(file.name));
    try {
      const bytes = new Uint8Array(await file.arrayBuffer());
      const known = isWorkbook(bytes) ? null : readImport(bytes, file.name, t);
      const sheet = known ? null : await sheetInFile(bytes);
      if (!known && !sheet) return failure(w.notATable(file.name));
      const brought = known ?? (sheet && (await assign({ name: file.name, sheet })));
      if (!brought || "failed" in brought) return brought;
      all.push(brought);
    } catch {
      return failure(t.problems.unreadable(file.name));
    }
  }
  return joined(all);
}

/** Applies an import: one step of undo. */
export function applyImport(brought: ToolImport, choice: "all" | "new", t: ToolsTexts, w: ToolFileTexts): TableMessage {
  const { list, fresh, changed, wrong } = planImport(useTools.getState().list, brought.incoming, choice);
  closeStep();
  editTools(() => list);
  const first = fresh[0] ?? changed[0]?.tool;
  if (first) openToolRow(first.id);
  return {
    failed: false,
    changed: true,
    sentences: [
      w.taken(brought.name, fresh.length, changed.length),
      ...(wrong.length > 0 ? [t.importedWrong(wrong.length)] : []),
      ...(brought.cutShort ? [t.cutShort] : []),
    ],
  };
}

export type ExportKind = "json" | "csv" | "turning" | "milling";

/** Downloads the table. Rows with errors are left out, and that is reported. */
export function exportTools(kind: ExportKind, language: Language, t: ToolsTexts, w: ToolFileTexts): TableMessage {
  const { list } = useTools.getState();
  const { table, mills, rows } = toolsOnDevice(list);
  const all = table.tools.length + mills.length;
  const files = {
    json: { name: "TOOLS.json", text: () => writeTableJson(table.tools, mills), count: all },
    csv: {
      name: "TOOLS.csv",
      text: () => writeTableCsv(table.tools, mills, decimalSign(language) === "," ? "comma" : "point"),
      count: all,
    },
    turning: { name: "TOOLTURN.TRN", text: () => writeTableText(table.tools), count: table.tools.length },
    milling: { name: "TOOL.T", text: () => writeMillText(mills), count: mills.length },
  };
  const { name, text, count } = files[kind];
  downloadText(text(), name);
  const meant = list.filter(
    (entry) => kind === "json" || kind === "csv" || isMillEntry(entry) === (kind === "milling"),
  );
  const without = meant
    .filter((entry) => !isSound(rows.get(entry.id)))
    .map((entry) => cellOf(entry, "T") || cellOf(entry, "NAME") || t.noNumber);
  return {
    failed: false,
    changed: false,
    sentences: [
      t.exported(name, count),
      ...(without.length > 0 ? [t.exportedWithout(without.join(", "))] : []),
      ...(kind === "turning" && table.tools.some((tool) => tool.holder) ? [w.noHolders] : []),
    ],
  };
}

/** Downloads the original table file, with the changes of its tools. */
export function exportToOrigin(origin: TableOrigin, t: ToolsTexts, w: ToolFileTexts): TableMessage {
  const made = writeBackTable(origin, useTools.getState().list);
  if (!made) return failure(t.problems.unreadable(origin.name));
  const bytes = encode(made.text, origin.encoding);
  downloadBytes(bytes, origin.name);
  return {
    failed: false,
    changed: false,
    sentences: [
      w.againDone(origin.name, made.changed, made.added, made.removed),
      ...(made.shipped > 0 ? [w.againShipped(made.shipped)] : []),
      ...(made.tooLong.length > 0
        ? [w.tooLong(made.tooLong.map(({ tool, column }) => `T${tool} ${column}`).join(", "))]
        : []),
      ...(decode(bytes).encoding === origin.encoding ? [] : [w.notEncodable]),
    ],
  };
}
