import type { ToolsTexts } from "../../i18n/en/tools.ts";
import { cellOf, isMillEntry, type EntryReading } from "../../program/tool-entry.ts";
import { readToolFile, writeTableJson } from "../../program/tool-table-json.ts";
import { writeMillText, writeTableText } from "../../program/tool-table-text.ts";
import { downloadText } from "../files/download.ts";
import { takeRows } from "./tool-edits.ts";
import { openRow } from "./tool-place.ts";
import { toolsOnDevice, useTools } from "./tool-store.ts";
import type { TableSaid } from "./TableStatus.tsx";

const failure = (sentence: string): TableSaid => ({ sentences: [sentence], failed: true, changed: false });

const isSound = (reading: EntryReading | undefined) => Boolean(reading?.tool ?? reading?.mill);

/** Files of older controls are not UTF-8: what can not be is read byte by byte. */
function decoded(bytes: ArrayBuffer): string {
  try {
    return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
  } catch {
    return new TextDecoder("windows-1252").decode(bytes);
  }
}

/** Takes the rows of a text into the table: one step of undo. */
export function importText(text: string, name: string, t: ToolsTexts): TableSaid {
  const read = readToolFile(text);
  if ("problem" in read) {
    switch (read.problem) {
      case "columnsMissing":
        return failure(t.problems.columnsMissing(name, read.columns.join(", ")));
      case "tooMany":
        return failure(t.problems.tooMany(name, read.most));
      case "notATable":
      case "noRows":
        return failure(t.problems[read.problem](name));
    }
  }
  const { replaced, added, first } = takeRows(read.rows);
  if (first) openRow(first);
  const { list } = useTools.getState();
  const taken = new Set(read.rows);
  const { rows } = toolsOnDevice(list);
  const wrong = list.filter((entry) => taken.has(entry.cells) && !isSound(rows.get(entry.id))).length;
  return {
    failed: false,
    changed: true,
    sentences: [
      t.imported(name, replaced, added),
      ...(wrong > 0 ? [t.importedWrong(wrong)] : []),
      ...(read.leftOut.length > 0 ? [t.leftOut(read.leftOut.join(", "))] : []),
      ...(read.cutShort ? [t.cutShort] : []),
    ],
  };
}

/** Larger files hold more than a tool table, bytes. */
const LARGEST = 20_000_000;

/** Takes the rows of a file into the table. */
export async function importFile(file: File, t: ToolsTexts): Promise<TableSaid> {
  if (file.size > LARGEST) return failure(t.problems.tooLarge(file.name));
  try {
    return importText(decoded(await file.arrayBuffer()), file.name, t);
  } catch {
    return failure(t.problems.unreadable(file.name));
  }
}

/** Hands the table to the downloads of the browser. Rows with errors stay here, and that is said. */
export function exportTools(kind: "json" | "turning" | "milling", t: ToolsTexts): TableSaid {
  const { list } = useTools.getState();
  const { table, mills, rows } = toolsOnDevice(list);
  const files = {
    json: { name: "TOOLS.json", text: () => writeTableJson(table.tools, mills), count: table.tools.length + mills.length },
    turning: { name: "TOOLTURN.TRN", text: () => writeTableText(table.tools), count: table.tools.length },
    milling: { name: "TOOL.T", text: () => writeMillText(mills), count: mills.length },
  };
  const { name, text, count } = files[kind];
  downloadText(text(), name);
  const meant = list.filter((entry) => kind === "json" || isMillEntry(entry) === (kind === "milling"));
  const without = meant.filter((entry) => !isSound(rows.get(entry.id))).map((entry) =>
    cellOf(entry, "T") || cellOf(entry, "NAME") || t.noNumber
  );
  return {
    failed: false,
    changed: false,
    sentences: [
      t.exported(name, count),
      ...(without.length > 0 ? [t.exportedWithout(without.join(", "))] : []),
      ...(kind === "turning" && table.tools.some((tool) => tool.holder) ? [t.holderNotExported] : []),
    ],
  };
}
