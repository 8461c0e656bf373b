import type { OwnTexts } from "../../i18n/en/tables/own.ts";
import { OWN_SIZES } from "../../program/edits/own-cycle.ts";
import { readLibraryFile, writeLibrary } from "../../program/edits/own-library.ts";
import { downloadText } from "../../app/base/download.ts";
import { takeEntries } from "../../app/fields/blocks/own-edits.ts";
import { openOwn } from "../../app/place/place.ts";
import { libraryOf } from "../../app/document/own-reading.ts";
import { useOwn } from "../../app/document/own-store.ts";
import type { TableMessage } from "../../app/fields/table/TableStatus.tsx";

const failure = (sentence: string): TableMessage => ({ sentences: [sentence], failed: true, changed: false });

/** Imports the descriptions of a text into the list: one step of undo. */
export function importOwnText(text: string, name: string, t: OwnTexts): TableMessage {
  const read = readLibraryFile(text);
  if ("problem" in read) {
    if (read.problem === "wrongCycle") return failure(t.files.wrongCycle(name, read.at));
    return failure(read.problem === "tooMany" ? t.files.tooMany(name, OWN_SIZES.cycles) : t.files[read.problem](name));
  }
  const before = new Set(useOwn.getState().list);
  const taken = takeEntries(read.entries);
  if (!taken) return failure(t.files.tooMany(name, OWN_SIZES.cycles));
  const { list } = useOwn.getState();
  const { rows } = libraryOf(list);
  const fresh = list.filter((entry) => !before.has(entry));
  if (fresh[0]) openOwn(fresh[0].id);
  const wrong = fresh.filter((entry) => (rows.get(entry.id)?.problems.length ?? 0) > 0).length;
  return {
    failed: false,
    changed: true,
    sentences: [
      t.files.imported(name, taken.replaced, taken.added),
      ...(wrong > 0 ? [t.files.importedWrong(wrong)] : []),
      ...(read.leftOut.length > 0 ? [t.files.leftOut(read.leftOut.join(", "))] : []),
    ],
  };
}

/** Larger files are no list of cycles, bytes. */
const LARGEST = 2_000_000;

/** Imports the descriptions of a file into the list. */
export async function importOwnFile(file: File, t: OwnTexts): Promise<TableMessage> {
  if (file.size > LARGEST) return failure(t.files.tooLarge(file.name));
  try {
    return importOwnText(new TextDecoder("utf-8", { fatal: true }).decode(await file.arrayBuffer()), file.name, t);
  } catch {
    return failure(t.files.unreadable(file.name));
  }
}

/** Downloads the list, including its faults. */
export function exportOwn(t: OwnTexts): TableMessage {
  const { list } = useOwn.getState();
  downloadText(writeLibrary(list), "CYCLES.json");
  return { sentences: [t.files.exported("CYCLES.json", list.length)], failed: false, changed: false };
}
