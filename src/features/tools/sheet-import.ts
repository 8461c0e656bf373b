import type { SheetTexts } from "../../i18n/tool-sheet-text.ts";
import {
  proposedAssignment,
  signatureOf,
  toolsOfSheet,
  type Assignment,
} from "../../program/tool-sheets/assignment.ts";
import { dayText } from "../../app/base/clock-text.ts";
import { time } from "../../app/base/clock.ts";
import { assignedBefore, rememberSheet } from "../../app/document/sheet-columns.ts";
import { toolsOnDevice, useTools } from "../../app/document/tool-store.ts";
import type { NamedSheet } from "./sheet-files.ts";
import type { ToolImport } from "./tool-files.ts";

/** Columns as they were assigned to a sheet with these titles, or as they are proposed. */
export function columnsFor({ sheet }: NamedSheet): { readonly assignment: Assignment; readonly day: string | null } {
  const before = assignedBefore(signatureOf(sheet));
  const fits = before?.columns.length === sheet.titles.length ? before : undefined;
  return fits ? { assignment: fits, day: fits.day } : { assignment: proposedAssignment(sheet), day: null };
}

/** The numbers of the table: a proposed number is none of them. */
export const numbersTaken = (): ReadonlySet<number> => {
  const { list } = useTools.getState();
  return new Set([...toolsOnDevice(list).rows.values()].flatMap(({ number }) => number ?? []));
};

/** Most proposed numbers that are listed. */
const MOST = 20;

/** The tools of a sheet by its assigned columns, which are remembered for the next sheet with these titles. */
export function importOfSheet(
  named: NamedSheet,
  assignment: Assignment,
  day: string | null,
  w: SheetTexts,
): ToolImport {
  const { name, sheet } = named;
  const { rows, twice, unused, given } = toolsOfSheet(sheet, assignment, numbersTaken());
  if (day === null) rememberSheet({ ...assignment, signature: signatureOf(sheet), day: dayText(new Date(time())) });
  const numbered = rows.flatMap(({ cells, isNumbered }) => (isNumbered ? [] : (cells.T ?? [])));
  const more = numbered.length > MOST ? " …" : "";
  return {
    name,
    incoming: {
      rows: rows.map(({ cells }) => cells),
      lines: rows.map(() => undefined),
      columns: rows.map(() => given),
      names: new Map(),
    },
    kept: [],
    leftOut: unused,
    cutShort: false,
    notes: [
      ...(day === null ? [] : [w.asOn(day)]),
      ...(twice.length > 0 ? [w.twiceNumbered(twice.join(", "))] : []),
      ...(numbered.length > 0 ? [w.numbered(numbered.slice(0, MOST).join(", ") + more)] : []),
    ],
    sheet: named,
  };
}
