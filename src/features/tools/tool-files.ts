import type { ToolsTexts } from "../../i18n/en/tables/tools.ts";
import type { Language } from "../../i18n/languages.ts";
import { decimalSign } from "../../i18n/number.ts";
import type { ToolFileTexts } from "../../i18n/tool-file-text.ts";
import { writeBackTable } from "../../program/tools/table-write-back.ts";
import { cellOf, isMillEntry, type EntryReading, type TableOrigin } from "../../program/tools/tool-entry.ts";
import { planImport, type IncomingTools } from "../../program/tools/tool-import.ts";
import { writeTableCsv } from "../../program/tools/tool-table-csv.ts";
import { writeTableJson } from "../../program/tools/tool-table-json.ts";
import { writeMillText, writeTableText } from "../../program/tools/tool-table-text.ts";
import type { RefusedItem } from "../../program/tool-files/facts.ts";
import type { ForeignTool } from "../../program/tool-files/foreign-tool.ts";
import type { ForeignFormat } from "../../program/tool-files/formats.ts";
import type { LengthUnit } from "../../kernel/units.ts";
import { decode, encode } from "../../app/document/encoding.ts";
import { downloadBytes, downloadText } from "../../app/base/download.ts";
import { closeStep } from "../../app/document/steps.ts";
import { openToolRow } from "../../app/place/place.ts";
import { editTools, toolsOnDevice, useTools } from "../../app/document/tool-store.ts";
import type { NamedSheet } from "./sheet-files.ts";
import type { TableMessage } from "../../app/fields/table/TableStatus.tsx";

/** A message about a file that could not be used. */
export const failure = (sentence: string): TableMessage => ({ sentences: [sentence], failed: true, changed: false });

const isSound = (reading: EntryReading | undefined) => Boolean(reading?.tool ?? reading?.mill);

/** Tools of other systems among the imported files. */
export interface ForeignImport {
  readonly formats: readonly ForeignFormat[];
  readonly tools: readonly ForeignTool[];
  readonly refused: readonly RefusedItem[];
  /** The unit that was assumed for lengths without one; null where all have theirs. */
  readonly assumedUnit: LengthUnit | null;
}

/** Contents of the import files, before they are applied to the table. */
export interface ToolImport {
  /** The names of the files. */
  readonly name: string;
  readonly incoming: IncomingTools;
  /** Unknown columns: those of control tables stay with the file, others are left out. */
  readonly kept: readonly string[];
  readonly leftOut: readonly string[];
  readonly cutShort: boolean;
  /** Tools of other systems, with the origin of each cell. */
  readonly foreign?: ForeignImport;
  /** The same files read again, with another unit for lengths without one. */
  readonly withUnit?: (unit: LengthUnit) => ToolImport;
  /** Sentences about how it was read, shown before it is applied. */
  readonly notes?: readonly string[];
  /** The sheet whose columns were assigned, so that they can be assigned again. */
  readonly sheet?: NamedSheet;
}

/** A file or what was pasted. */
export interface ImportSource {
  readonly name: string;
  readonly size: number;
  readonly arrayBuffer: () => Promise<ArrayBuffer>;
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
      text: () => writeTableCsv(table.tools, mills, decimalSign(language)),
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
