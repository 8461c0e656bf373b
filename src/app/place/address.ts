import type { LessonPage } from "../../course/progress.ts";
import type { WorkSection } from "./place.ts";

/** A place with its own address: after `#`, so that it works in any folder and without a server. */
export type Address =
  | StartAddress
  | WorksAddress
  | CourseAddress
  | WorkAddress
  | SheetAddress
  | PlanAddress
  | ToolsAddress
  | OwnAddress
  | GuideAddress;

/** The start page, and whether the dialog that finds a cycle is open. */
export interface StartAddress {
  readonly page: "start";
  readonly which: boolean;
}

/** The list of all works of this device. */
export interface WorksAddress {
  readonly page: "works";
}

/** The course: its list, or a page of a lesson. */
export interface CourseAddress {
  readonly page: "course";
  readonly lesson: string | null;
  readonly at: LessonPage;
}

/** A work of this device by its key, with the shown section. */
export interface WorkAddress {
  readonly page: "work";
  readonly work: string;
  readonly section: WorkSection;
  readonly which: boolean;
}

/** The setup sheet of a work. */
export interface SheetAddress {
  readonly page: "sheet";
  readonly work: string;
}

/** The working plan of the part that was open last. */
export interface PlanAddress {
  readonly page: "plan";
}

/** The tool table: with the row of a number, or one of its two kinds. */
export interface ToolsAddress {
  readonly page: "tools";
  readonly number: number | null;
  readonly milling: boolean;
}

/** The own cycles, with the id of the open description. */
export interface OwnAddress {
  readonly page: "own";
  readonly row: string | null;
}

/** A page of the guide or the glossary, by its address. */
export interface GuideAddress {
  readonly page: "guide";
  readonly path: readonly string[];
}

const SECTIONS: Readonly<Record<WorkSection, true>> = {
  prompts: true,
  setup: true,
  contour: true,
  findings: true,
  program: true,
  text: true,
  block: true,
  structure: true,
};
const isSection = (text: string): text is WorkSection => Object.hasOwn(SECTIONS, text);
const WHICH = "which";
const SHEET = "sheet";
const TASKS = "tasks";

function parts(address: Address): readonly string[] {
  switch (address.page) {
    case "start":
      return address.which ? [WHICH] : [];
    case "works":
    case "plan":
      return [address.page];
    case "course":
      return [
        "course",
        ...(address.lesson === null ? [] : [address.lesson, ...(address.at === 1 ? [] : [String(address.at)])]),
      ];
    case "work": {
      const { work, section, which } = address;
      return ["work", work, ...(section === "prompts" ? [] : [section]), ...(which ? [WHICH] : [])];
    }
    case "sheet":
      return ["work", address.work, SHEET];
    case "tools":
      if (address.number !== null) return ["tools", String(address.number)];
      return address.milling ? ["tools", "milling"] : ["tools"];
    case "own":
      return address.row === null ? ["own"] : ["own", address.row];
    case "guide":
      return address.path;
  }
}

/** The address of a place, from `#` on. */
export const printAddress = (address: Address): string => `#/${parts(address).map(encodeURIComponent).join("/")}`;

function decoded(part: string): string | null {
  try {
    return decodeURIComponent(part);
  } catch {
    return null;
  }
}

function workAddress([work = "", ...more]: readonly string[]): WorkAddress | SheetAddress | null {
  if (work !== "" && more.length === 1 && more[0] === SHEET) return { page: "sheet", work };
  const which = more.at(-1) === WHICH;
  const [section = "prompts", ...rest] = which ? more.slice(0, -1) : more;
  return work !== "" && rest.length === 0 && isSection(section) ? { page: "work", work, section, which } : null;
}

function toolsAddress([row, ...more]: readonly string[]): ToolsAddress | null {
  if (more.length > 0) return null;
  if (row === undefined || row === "milling") return { page: "tools", number: null, milling: row !== undefined };
  return /^\d{1,9}(?:\.\d{1,9})?$/.test(row) ? { page: "tools", number: Number(row), milling: false } : null;
}

function courseAddress([lesson, at = "1", ...more]: readonly string[]): CourseAddress | null {
  if (more.length > 0 || !(at === TASKS || /^[1-9]\d?$/.test(at))) return null;
  return { page: "course", lesson: lesson ?? null, at: at === TASKS ? at : Number(at) };
}

/** Whether an address, from `#` on, is a share link: it then names no place. */
export const isShareLink = (hash: string): boolean => /^#(?:[pw]|[htrs]\d+)=/.test(hash);

/** The place of an address, from `#` on; null if it names none. */
export function parseAddress(hash: string): Address | null {
  if (!hash.startsWith("#/")) return null;
  const found = hash
    .slice(2)
    .split("/")
    .filter((part) => part !== "")
    .map(decoded);
  const [page, ...more] = found.filter((part) => part !== null);
  if (found.includes(null)) return null;
  switch (page) {
    case undefined:
      return { page: "start", which: false };
    case WHICH:
      return more.length === 0 ? { page: "start", which: true } : null;
    case "works":
    case "plan":
      return more.length === 0 ? { page } : null;
    case "course":
      return courseAddress(more);
    case "work":
      return workAddress(more);
    case "tools":
      return toolsAddress(more);
    case "own":
      return more.length < 2 ? { page: "own", row: more[0] ?? null } : null;
    case "guide":
    case "glossary":
      return more.length < 3 ? { page: "guide", path: [page, ...more] } : null;
    default:
      return null;
  }
}
