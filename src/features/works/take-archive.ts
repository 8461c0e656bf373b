import { readOwn, type OwnEntry } from "../../program/edits/own-cycle.ts";
import { mergedLibrary, type OwnList } from "../../program/edits/own-library.ts";
import { mergedTools, sameList, type ToolList } from "../../program/tools/tool-list.ts";
import { drawnId } from "../../app/base/chance.ts";
import { editOwn, useOwn } from "../../app/document/own-store.ts";
import { writeKeptOwn } from "../../app/records/keep-own.ts";
import type { ArchivedWork, ReadArchive } from "../../app/records/archive.ts";
import { readWork } from "../../app/records/device.ts";
import { fingerprint } from "../../app/records/difference.ts";
import { useKeeping } from "../../app/records/keep.ts";
import { addWorks } from "../../app/records/works.ts";
import { changeLanguage, changeSettings } from "../../app/base/settings/settings.ts";
import { editTools, toolsOnDevice, useTools } from "../../app/document/tool-store.ts";
import { courseHere, takeCourse } from "./bring-course.ts";

/** What becomes of a work that is brought in: it is new, here already, or comes beside another one of its name. */
export type ArchivedState = "fresh" | "same" | "beside";

/** How each work of an archive stands to those of this device. */
export async function statesOf(works: readonly ArchivedWork[]): Promise<readonly ArchivedState[]> {
  const here = new Map<string, string[]>();
  for (const { work, name } of useKeeping.getState().works) here.set(name, [...(here.get(name) ?? []), work]);
  const printOf = async (work: string) => {
    const kept = await readWork(work);
    return kept && fingerprint(kept.job);
  };
  const prints = new Map<string, Promise<readonly (string | null)[]>>();
  const printsOf = (name: string) => {
    const made = prints.get(name) ?? Promise.all((here.get(name) ?? []).map(printOf));
    prints.set(name, made);
    return made;
  };
  return Promise.all(works.map(async ({ job }) => {
    const known = await printsOf(job.name);
    if (known.includes(fingerprint(job))) return "same";
    return known.length > 0 ? "beside" : "fresh";
  }));
}

/** What a table of the device does with one that is brought in. */
export type TableChoice = "keep" | "missing" | "replace";

/** Rows of a table whose numbers this device does not have; null where both tables are the same. */
export function missingTools(brought: ToolList, mine: ToolList): ToolList | null {
  if (sameList(brought, mine)) return null;
  const [theirs, ours] = [toolsOnDevice(brought).rows, toolsOnDevice(mine).rows];
  const taken = new Set(mine.map(({ id }) => ours.get(id)?.number ?? null));
  return brought.filter(({ id }) => !taken.has(theirs.get(id)?.number ?? null));
}

/** The same of own cycles. */
export function missingOwn(brought: OwnList, mine: OwnList): OwnList | null {
  if (writeKeptOwn(brought) === writeKeptOwn(mine)) return null;
  const numberOf = (entry: OwnEntry) => readOwn(entry).number ?? entry.number.trim();
  const taken = new Set(mine.map(numberOf));
  return brought.filter((entry) => !taken.has(numberOf(entry)));
}

/** What is taken of an archive. */
export interface ArchiveChoice {
  readonly works: readonly ArchivedWork[];
  readonly tools: TableChoice;
  readonly own: TableChoice;
  readonly settings: boolean;
  /** What was reached in the course, tasks, forms and results; what is better here stays. */
  readonly course: boolean;
}

/** Takes what was chosen; nothing on the device is written over. Says how many works came, and how many found no room. */
export async function takeArchive(archive: ReadArchive, choice: ArchiveChoice): Promise<{ readonly kept: number; readonly full: number }> {
  const here = new Set(useKeeping.getState().works.map(({ work }) => work));
  const lying = choice.works.map((each) => {
    const free = each.work !== "" && !here.has(each.work);
    const work = free ? each.work : drawnId();
    here.add(work);
    return { ...each, work };
  });
  const kept = await addWorks(lying);
  const { tools, own, settings } = archive;
  if (tools && choice.tools === "replace") editTools(() => tools);
  if (tools && choice.tools === "missing")
    editTools((list) => mergedTools(list, (missingTools(tools, list) ?? []).map(({ cells }) => cells)).list);
  if (own && choice.own === "replace") editOwn(() => own);
  if (own && choice.own === "missing") editOwn((list) => mergedLibrary(list, missingOwn(own, list) ?? []).list);
  if (choice.course) takeCourse(archive, new Map(choice.works.map(({ work }, i) => [work, lying[i]?.work ?? work])));
  if (settings && choice.settings) {
    const { language, cutting, machine, ...others } = settings;
    // Somebody who goes by the shipped cutting data, or by no machine, has none to bring: the shop's own stay.
    changeSettings({ ...others, ...(cutting !== "" && { cutting }), ...(machine !== "" && { machine }) });
    await changeLanguage(language);
  }
  return { kept, full: lying.length - kept };
}

/** The tables of this device, for what is said of those in an archive. */
export function tablesHere() {
  return { tools: useTools.getState().list, own: useOwn.getState().list, course: courseHere() };
}
