import { notice } from "../app/base/notices.ts";
import { goHome, goToEntrance } from "../app/document/go-home.ts";
import { openContent, useEditor } from "../app/document/store.ts";
import { showToolNumber } from "../app/document/tool-row.ts";
import { toolsOnDevice, useTools } from "../app/document/tool-store.ts";
import { kindOf } from "../app/document/work.ts";
import type { Address, ToolsAddress, WorkAddress } from "../app/place/address.ts";
import {
  closeOver,
  cover,
  workElsewhere,
  openToolRow,
  shownPage,
  sectionsOf,
  showGuide,
  showOwn,
  showSection,
  showToolKind,
  showTools,
  showWhich,
  toFirstPrompt,
  uncover,
  uncoverAll,
  usePlace,
} from "../app/place/place.ts";
import { openWork } from "../app/records/keep.ts";

function currentToolsAddress(): ToolsAddress {
  const { row, kind } = usePlace.getState().tools;
  const number = row === null ? null : (toolsOnDevice(useTools.getState().list).rows.get(row)?.number ?? null);
  return { page: "tools", number, milling: number === null && kind === "milling" };
}

/** Address of the page on top. */
export function currentAddress(): Address {
  const place = usePlace.getState(),
    page = shownPage(place);
  const { work } = useEditor.getState(),
    content = openContent();
  const which = place.over?.dialog === "which";
  switch (page.page) {
    case "guide":
    case "works":
    case "plan":
      return page;
    case "own":
      return { page: "own", row: place.own.row };
    case "tools":
      return currentToolsAddress();
    case "course":
      return { page: "course", lesson: page.lesson, at: page.lesson === null ? 1 : page.at };
    case "elsewhere":
      return { page: "work", work: page.of.work, section: "prompts", which: false };
    case "sheet":
    case "work": {
      if (work === null || !content) return { page: "start", which };
      if (page.page === "sheet") return { page: "sheet", work };
      const kind = kindOf(content);
      // Opening a prompt sets the section "prompts": in a program those are in the block.
      const asked = kind === "program" ? "block" : "prompts";
      const section = sectionsOf(kind).includes(place.section) ? place.section : asked;
      return { page: "work", work, section, which };
    }
    case "start":
      return { page: "start", which };
  }
}

/** Shows a work, or that another tab has it; a work that is not on this device is announced on the start page. */
async function showWorkAt({ work, section }: Pick<WorkAddress, "work" | "section">): Promise<void> {
  if (useEditor.getState().work !== work) {
    if (workElsewhere(usePlace.getState())?.work === work) return uncoverAll();
    toFirstPrompt();
    if (!(await openWork(work))) {
      notice("workNotHere");
      return goHome();
    }
  }
  uncoverAll();
  const content = openContent();
  if (content && usePlace.getState().section !== section && sectionsOf(kindOf(content)).includes(section))
    showSection(section);
}

function showRow({ number, milling }: ToolsAddress): void {
  showTools();
  if (number !== null) showToolNumber(number);
  else {
    openToolRow(null);
    showToolKind(milling ? "milling" : "turning");
  }
}

/** Shows what an address names. */
export async function goTo(address: Address): Promise<void> {
  if (address.page !== "guide" && shownPage(usePlace.getState()).page === "guide") uncover();
  switch (address.page) {
    case "guide":
      return showGuide(...address.path);
    case "plan":
      return cover(address);
    case "own":
      return showOwn(address.row ?? undefined);
    case "tools":
      return showRow(address);
    case "sheet":
      // The sheet is over the last section of its work.
      await showWorkAt({ work: address.work, section: usePlace.getState().section });
      if (useEditor.getState().work === address.work) cover({ page: "sheet" });
      return;
    case "course":
    case "works":
      return goToEntrance(address);
    case "start":
    case "work":
      if (address.page === "work") await showWorkAt(address);
      else goHome();
      if (!address.which) closeOver();
      else if (usePlace.getState().over?.dialog !== "which") showWhich();
  }
}
