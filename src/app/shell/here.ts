import { useCoursePlace } from "../place/course-place.ts";
import { hideOwn, showOwn, useOwnPlace } from "../document/own-place.ts";
import { hideGuide, showGuide, useGuidePlace } from "../place/guide-place.ts";
import { usePlace, type WorkSection } from "../place/place.ts";
import { useElsewhere } from "../place/elsewhere.ts";
import { notice } from "../base/notices.ts";
import { openWork } from "../records/keep.ts";
import { useEditor } from "../document/store.ts";
import { hideTools, openRow, showKind, showToolNumber, showTools, useToolPlace } from "../document/tool-place.ts";
import { toolsOnDevice, useTools } from "../document/tool-store.ts";
import { thirdColumn } from "../base/use-media.ts";
import { hideWhich, showWhich, useWhichPlace } from "../document/which-place.ts";
import { useWorksPlace } from "../place/works-place.ts";
import { hideSheet, sheetIsShown, showSheet } from "../document/sheet-place.ts";
import type { Address, SheetAddress, ToolsAddress, WorkAddress } from "../place/address.ts";
import { goHome, goToCourse, goToWorks } from "../document/go-home.ts";

const JOB_SECTIONS: readonly WorkSection[] = ["prompts", "setup", "contour", "findings", "program"];
const PROGRAM_SECTIONS: readonly WorkSection[] = ["text", "block", "structure", "findings"];

/** The section of a program that is shown first: where its text stands beside it, its parts. */
const firstOfProgram = (): WorkSection => (thirdColumn() ? "structure" : "text");

/** The section that an opened program begins with, where none was asked for. */
export function beginProgram(): void {
  if (!PROGRAM_SECTIONS.includes(usePlace.getState().section)) usePlace.setState({ section: firstOfProgram(), field: null });
}

/** The section of the open work as its workplace shows it. */
function shownSection(): WorkSection {
  const { section } = usePlace.getState();
  if (useEditor.getState().program) return PROGRAM_SECTIONS.includes(section) ? section : "block";
  return JOB_SECTIONS.includes(section) ? section : "prompts";
}

function toolsHere(): ToolsAddress {
  const { row, kind } = useToolPlace.getState();
  const number = row === null ? null : toolsOnDevice(useTools.getState().list).rows.get(row)?.number ?? null;
  return { page: "tools", number, milling: number === null && kind === "milling" };
}

/** The place that the page shows now. */
export function here(): Address {
  const { path } = useGuidePlace.getState();
  if (path) return { page: "guide", path };
  const own = useOwnPlace.getState();
  if (own.shown) return { page: "own", row: own.row };
  if (useToolPlace.getState().shown) return toolsHere();
  const { work } = useEditor.getState();
  if (work !== null && sheetIsShown()) return { page: "sheet", work };
  const which = useWhichPlace.getState().shown;
  const elsewhere = useElsewhere.getState().shown;
  if (work === null && elsewhere) return { page: "work", work: elsewhere.work, section: "prompts", which: false };
  const course = useCoursePlace.getState();
  if (work === null && course.shown) return { page: "course", lesson: course.lesson, at: course.lesson === null ? 1 : course.page };
  if (work === null && useWorksPlace.getState().shown) return { page: "works" };
  return work === null ? { page: "start", which } : { page: "work", work, section: shownSection(), which };
}

async function openNamed({ work, section }: Pick<WorkAddress, "work" | "section">): Promise<void> {
  if (useEditor.getState().work !== work) {
    if (useElsewhere.getState().shown?.work === work) return;
    usePlace.setState({ section: "prompts", prompt: null, field: null });
    if (!await openWork(work)) {
      notice("workNotHere");
      return goHome();
    }
  }
  if (usePlace.getState().section !== section) usePlace.setState({ section, field: null });
  if (useEditor.getState().program) beginProgram();
}

/** The sheet lies over the section of its work that was shown last. */
async function openSheet({ work }: SheetAddress): Promise<void> {
  await openNamed({ work, section: usePlace.getState().section });
  if (useEditor.getState().work === work) showSheet();
}

function showRow({ number, milling }: ToolsAddress): void {
  showTools();
  if (number !== null) showToolNumber(number);
  else {
    openRow(null);
    showKind(milling ? "milling" : "turning");
  }
}

/** Shows a place. A work that is not on this device is said so, on the start page. */
export async function goTo(address: Address): Promise<void> {
  if (address.page === "guide") return showGuide(...address.path);
  hideGuide();
  if (address.page === "own") return showOwn(address.row ?? undefined);
  hideOwn();
  if (address.page === "tools") return showRow(address);
  hideTools();
  if (address.page === "sheet") {
    hideWhich();
    return openSheet(address);
  }
  hideSheet();
  if (address.page === "course") {
    hideWhich();
    return goToCourse(address.lesson, address.at);
  }
  if (address.page === "works") {
    hideWhich();
    return goToWorks();
  }
  if (address.page === "start") goHome();
  else await openNamed(address);
  if (address.which) showWhich(useWhichPlace.getState().region);
  else hideWhich();
}
