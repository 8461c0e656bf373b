import type { ToolsTexts } from "../../i18n/en/tables/tools.ts";
import type { ToolFileTexts } from "../../i18n/tool-file-text.ts";
import type { LengthUnit } from "../../kernel/units.ts";
import { TOOL_FILE_ENDINGS } from "../../program/tool-files/formats.ts";
import { numbered, readToolFiles, type ReadToolFile } from "../../program/tool-files/read-tool-files.ts";
import { readEntry, tableOrigin, type TableLine } from "../../program/tools/tool-entry.ts";
import type { ToolList } from "../../program/tools/tool-list.ts";
import { readSheet } from "../../program/tool-sheets/sheet.ts";
import { textsOfFile, type FileText } from "../../app/document/file-texts.ts";
import { useTools } from "../../app/document/tool-store.ts";
import type { Encoding } from "../../app/document/work.ts";
import type { TableMessage } from "../../app/fields/table/TableStatus.tsx";
import { isWorkbook, sheetInFile, type NamedSheet } from "./sheet-files.ts";
import { failure, type ForeignImport, type ImportSource, type ToolImport } from "./tool-files.ts";

/** Joins what the files of other systems contain, with a number for each tool; null when there are none. */
function foreignImport(read: readonly ReadToolFile[], list: ToolList): ForeignImport | null {
  const found = read.flatMap(({ content }) => ("foreign" in content ? [content.foreign] : []));
  if (found.length === 0) return null;
  const rows = read.flatMap(({ content }) => ("table" in content ? content.table.rows : []));
  const numbers = [...list, ...rows.map((cells) => ({ id: "", cells }))].map((entry) => readEntry(entry).number);
  return {
    formats: [...new Set(found.map(({ format }) => format))],
    tools: numbered(
      found.flatMap(({ tools }) => tools),
      new Set(numbers.filter((number) => number !== null)),
    ),
    refused: found.flatMap(({ refused }) => refused),
    assumedUnit: found.find(({ assumedUnit }) => assumedUnit !== null)?.assumedUnit ?? null,
  };
}

/** Files of an archive that are no tables of tools are passed over, unless nothing else is in it. */
function toldFiles(read: readonly ReadToolFile[], texts: readonly FileText[]): readonly ReadToolFile[] {
  const packed = new Set(texts.filter((each) => each.packed).map((each) => each.name));
  const useful = read.filter(({ name, content }) => !("problem" in content) || !packed.has(name));
  return useful.length > 0 ? useful : read.slice(0, 1);
}
/** Larger files are no tool table, bytes. */
const LARGEST = 20_000_000;

/** Says why a file is no table of tools. */
function problemOf(
  { name, content }: { readonly name: string; readonly content: ProblemContent },
  t: ToolsTexts,
  w: ToolFileTexts,
): TableMessage {
  switch (content.problem) {
    case "columnsMissing":
      return failure(t.problems.columnsMissing(name, content.columns.join(", ")));
    case "tooMany":
      return failure(t.problems.tooMany(name, content.most));
    case "noRows":
      return failure(t.problems.noRows(name));
    case "notATable":
      return failure(w.notATable(name));
  }
}
type ProblemContent = Extract<ReadToolFile["content"], { readonly problem: unknown }>;
type TableContent = Extract<ReadToolFile["content"], { readonly table: unknown }>;

function tableImport(name: string, { table: read, text }: TableContent, encoding: Encoding): ToolImport {
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
  const sheet = !table && leftOut.length > 0 && !/^\s*[{[]/.test(text) ? readSheet(text) : null;
  return {
    name,
    incoming,
    kept: table ? leftOut : [],
    leftOut: table ? [] : leftOut,
    cutShort,
    ...(sheet && { sheet: { name, sheet } }),
  };
}

/** The rows of another system's tools: each replaces all cells of its number. */
const foreignRows = (name: string, { tools }: ForeignImport, cutShort: boolean): ToolImport => ({
  name,
  incoming: {
    rows: tools.map(({ cells }) => cells),
    lines: tools.map(() => undefined),
    columns: tools.map(() => undefined),
    names: new Map(),
  },
  kept: [],
  leftOut: [],
  cutShort,
});

const joined = (all: readonly ToolImport[], name: string): ToolImport => ({
  name,
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

interface Reading {
  readonly t: ToolsTexts;
  readonly w: ToolFileTexts;
  /** Assigns the columns of a sheet with titles of its own; null when that was given up. */
  readonly assign: (sheet: NamedSheet) => Promise<ToolImport | null>;
}

/** What the texts of the chosen files contain; `sheets` were assigned and stay as they are with another unit. */
function importOf(
  texts: readonly FileText[],
  unit: LengthUnit,
  name: string,
  sheets: readonly ToolImport[],
): ToolImport {
  const read = toldFiles(readToolFiles(texts, unit), texts);
  const foreign = foreignImport(read, useTools.getState().list);
  const cutShort = read.some(({ content }) => "foreign" in content && content.foreign.cutShort);
  const tables = read.flatMap(({ name: file, content }) => {
    const encoding = texts.find((each) => each.name === file)?.encoding ?? "utf-8";
    return "table" in content ? [tableImport(file, content, encoding)] : [];
  });
  const all = joined([...tables, ...(foreign ? [foreignRows(name, foreign, cutShort)] : []), ...sheets], name);
  return foreign ? { ...all, foreign, withUnit: (other) => importOf(texts, other, name, sheets) } : all;
}

/** The chosen files: texts, also of archives, and workbooks. */
interface Opened {
  readonly texts: FileText[];
  readonly sheets: NamedSheet[];
  readonly bytes: Map<string, Uint8Array>;
}

async function opened(files: readonly ImportSource[], { t }: Reading): Promise<Opened | TableMessage> {
  const all: Opened = { texts: [], sheets: [], bytes: new Map() };
  for (const file of files) {
    if (file.size > LARGEST) return failure(t.problems.tooLarge(file.name));
    try {
      const bytes = new Uint8Array(await file.arrayBuffer());
      const workbook = isWorkbook(bytes) ? await sheetInFile(bytes) : null;
      const found = workbook ? [] : textsOfFile(file.name, bytes, TOOL_FILE_ENDINGS);
      if (found === "tooLarge") return failure(t.problems.tooLarge(file.name));
      if (workbook) all.sheets.push({ name: file.name, sheet: workbook });
      else if (found.length === 0) return failure(t.problems.noRows(file.name));
      all.texts.push(...found);
      all.bytes.set(file.name, bytes);
    } catch {
      return failure(t.problems.unreadable(file.name));
    }
  }
  return all;
}

/** Reads all chosen files, or returns the fault of the first one that cannot be read; null when it was given up. */
export async function readImportFiles(
  files: readonly ImportSource[],
  reading: Reading,
): Promise<ToolImport | TableMessage | null> {
  const { t, w, assign } = reading;
  const found = await opened(files, reading);
  if ("failed" in found) return found;
  const { texts, sheets, bytes } = found;
  const unknown = new Set<string>();
  for (const { name, content } of toldFiles(readToolFiles(texts, "mm"), texts)) {
    if (!("problem" in content)) continue;
    const own = content.problem === "notATable" ? bytes.get(name) : undefined;
    const sheet = own && (await sheetInFile(own));
    if (!sheet) return problemOf({ name, content }, t, w);
    sheets.push({ name, sheet });
    unknown.add(name);
  }
  const assigned: ToolImport[] = [];
  for (const sheet of sheets) {
    const brought = await assign(sheet);
    if (!brought) return null;
    assigned.push(brought);
  }
  const known = texts.filter(({ name }) => !unknown.has(name));
  return importOf(known, "mm", files.map((each) => each.name).join(", "), assigned);
}
