import { PART_FORMAT, printPart, readPart } from "../../planning/part/part-file.ts";
import type { FinishedPart } from "../../planning/part/finished-part.ts";
import { downloadText } from "../../app/base/download.ts";
import { showPlan } from "../../app/place/place.ts";
import { addPart } from "../../app/records/part-store.ts";
import { adopted } from "./part-rows.ts";
import { sayOpened, showTab } from "./plan-place.ts";

/** Longer files are no part, bytes. */
const LARGEST = 1_000_000;
/** The format of any edition, as a part file begins with it. */
const FORMAT = PART_FORMAT.replace(/(?<!\d)\d+$/, "");

/** The file of a finished part among others; null where none is one. */
export async function findPartFile(files: readonly File[]): Promise<File | null> {
  for (const file of files)
    if (/\.json$/i.test(file.name) && file.size <= LARGEST && (await file.text()).includes(FORMAT)) return file;
  return null;
}

/** Opens a part file as a new part on the page of working plans, which names its problems where it is none. */
export async function openPartFile(file: File): Promise<void> {
  const { part, problems } = await file.text().then(readPart, () => ({ part: null, problems: [] }));
  if (part) addPart(adopted(part));
  sayOpened({ name: file.name, isOpen: part !== null, problems });
  showTab("part");
  showPlan();
}

/** Downloads a part as a file. */
export function savePartFile(part: FinishedPart): void {
  const stem = part.name.trim().replaceAll(/[^\p{L}\p{N}_-]+/gu, "-") || "PART";
  downloadText(printPart(part), `${stem}.part.json`);
}
