import type { ToolsTexts } from "../../i18n/en/tables/tools.ts";
import type { ToolFileTexts } from "../../i18n/tool-file-text.ts";
import type { LengthUnit } from "../../kernel/units.ts";
import { TOOL_FILE_ENDINGS } from "../../program/tool-files/formats.ts";
import { numbered, readToolFiles, type ReadToolFile } from "../../program/tool-files/read-tool-files.ts";
import { readEntry, tableOrigin, type TableLine } from "../../program/tools/tool-entry.ts";
import type { ToolList } from "../../program/tools/tool-list.ts";
import { textsOfFile, type FileText } from "../../app/document/file-texts.ts";
import { useTools } from "../../app/document/tool-store.ts";
import type { Encoding } from "../../app/document/work.ts";
import type { TableMessage } from "../../app/fields/table/TableStatus.tsx";
import { failure, type ForeignImport, type ToolImport } from "./tool-files.ts";

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
  return { name, incoming, kept: table ? leftOut : [], leftOut: table ? [] : leftOut, cutShort };
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
});

/** Reads texts with a unit for the lengths that have none; reading again with another unit needs no file. */
function readTexts(texts: readonly FileText[], unit: LengthUnit, { t, w, name }: Reading): ToolImport | TableMessage {
  const read = toldFiles(readToolFiles(texts, unit), texts);
  const problem = read.find(({ content }) => "problem" in content);
  if (problem && "problem" in problem.content) return problemOf({ name: problem.name, content: problem.content }, t, w);
  const foreign = foreignImport(read, useTools.getState().list);
  const cutShort = read.some(({ content }) => "foreign" in content && content.foreign.cutShort);
  const tables = read.flatMap(({ name: file, content }) => {
    const encoding = texts.find((each) => each.name === file)?.encoding ?? "utf-8";
    return "table" in content ? [tableImport(file, content, encoding)] : [];
  });
  const all = joined([...tables, ...(foreign ? [foreignRows(name, foreign, cutShort)] : [])], name);
  if (!foreign) return all;
  const withUnit = (other: LengthUnit) => readTexts(texts, other, { t, w, name }) as ToolImport;
  return { ...all, foreign, withUnit };
}

interface Reading {
  readonly t: ToolsTexts;
  readonly w: ToolFileTexts;
  /** Names of the chosen files. */
  readonly name: string;
}

/** Reads all chosen files, or returns the fault of the first one that cannot be read. */
export async function readImportFiles(
  files: readonly File[],
  t: ToolsTexts,
  w: ToolFileTexts,
): Promise<ToolImport | TableMessage> {
  const texts: FileText[] = [];
  for (const file of files) {
    if (file.size > LARGEST) return failure(t.problems.tooLarge(file.name));
    try {
      const found = textsOfFile(file.name, new Uint8Array(await file.arrayBuffer()), TOOL_FILE_ENDINGS);
      if (found === "tooLarge") return failure(t.problems.tooLarge(file.name));
      if (found.length === 0) return failure(t.problems.noRows(file.name));
      texts.push(...found);
    } catch {
      return failure(t.problems.unreadable(file.name));
    }
  }
  const name = files.map((each) => each.name).join(", ");
  return readTexts(texts, "mm", { t, w, name });
}
