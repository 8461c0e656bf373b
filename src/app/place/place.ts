import { create } from "zustand";
import type { Site } from "../../cycles/wanted.ts";
import type { LessonPage } from "../../course/progress.ts";
import type { Ring, Segment } from "../../kernel/geometry/point.ts";
import { thirdColumn } from "../base/use-media.ts";

const JOB_SECTIONS = ["prompts", "setup", "contour", "findings", "program"] as const;
const PROGRAM_SECTIONS = ["text", "block", "structure", "findings"] as const;
/** The sections of a program or of a job, in the order of their tabs. */
export const sectionsOf = (isProgram: boolean): readonly WorkSection[] => (isProgram ? PROGRAM_SECTIONS : JOB_SECTIONS);
/** The parts of the page that take turns where there is little room. */
export type JobSection = (typeof JOB_SECTIONS)[number];
/** Those of a whole program: its text, the dialog of one block, the list of its parts. */
export type ProgramSection = (typeof PROGRAM_SECTIONS)[number];
export type WorkSection = JobSection | ProgramSection;
export type ToolKind = "turning" | "milling";

/** What is shown where no work is open. */
export type Entrance =
  | { readonly page: "start" }
  | { readonly page: "works" }
  /** The list of lessons where `lesson` is null. */
  | { readonly page: "course"; readonly lesson: string | null; readonly at: LessonPage };

/** A work that was asked for here and that another tab has: it was open there, or that tab took it from this one. */
export interface WorkElsewhere {
  readonly work: string;
  readonly name: string;
  readonly cause: "isOpen" | "wasTaken";
}
/** What an opened work shows. */
export type WorkPage = { readonly page: "work" } | { readonly page: "elsewhere"; readonly of: WorkElsewhere };

/** A page of the guide as its address has it, behind "#/": ["guide", "812", "Q463"], ["glossary", "infeed"]. */
export type GuidePath = readonly string[];
/** A page that covers others, with a way back to them. */
export type Cover =
  | { readonly page: "sheet" }
  | { readonly page: "tools" }
  | { readonly page: "own" }
  | { readonly page: "guide"; readonly path: GuidePath };
export type Page = Entrance | WorkPage | Cover;

/** A place in an opened work: its finished contour, the stretch that is meant, and what stands there. */
export interface WhichRegion {
  readonly contour: readonly Segment[];
  readonly first: number;
  readonly last: number;
  readonly site: Site;
  /** What stands in the chuck at the end of the work. */
  readonly stock: readonly Ring[];
  /** Which material is meant at first. */
  readonly begins: "solid" | "now";
}
/**
 * Shows a block of the open work: by its index in one of its files (null: the program that runs), and by its number.
 */
export type ShowBlock = (file: string | null, index: number, number: number) => void;
/** Another text of the file that is shown, with its name. */
export interface OtherText {
  readonly name: string;
  readonly text: string;
}
/**
 * A dialog over the page: which cycle makes a shape (`region` null: any), or the open program compared with another
 * text.
 */
export type Over =
  | { readonly dialog: "which"; readonly region: WhichRegion | null }
  | { readonly dialog: "comparison"; readonly showBlock: ShowBlock; readonly against: OtherText | null };

/** Where the operator is. It is no part of the work, so undo does not touch it. */
export interface Place {
  /** Pages that lie on each other: an entrance, perhaps the work, perhaps covers. The last one is seen. */
  readonly pages: readonly [Entrance, ...(WorkPage | Cover)[]];
  readonly over: Over | null;
  readonly section: WorkSection;
  /** Q number of the open prompt; null when the dialog is at its end. */
  readonly prompt: string | null;
  /** Text of the open prompt as it was when it opened, for Escape. */
  readonly before: string;
  /** Counts up each time the open field should take the keyboard. */
  readonly focus: number;
  /** Field of the set-up or contour that should take the keyboard, with its own count. */
  readonly field: string | null;
  /**
   * The open row of the tool table by its id (one that is gone counts as the first of its kind), and the kind shown
   * while none is open.
   */
  readonly tools: { readonly row: string | null; readonly kind: ToolKind };
  /**
   * The open description of an own cycle by its id; `focus` counts up each time its first field should take the
   * keyboard.
   */
  readonly own: { readonly row: string | null; readonly focus: number };
}

export const usePlace = create<Place>(() => ({
  pages: [{ page: "start" }],
  over: null,
  section: "prompts",
  prompt: null,
  before: "",
  focus: 0,
  field: null,
  tools: { row: null, kind: "turning" },
  own: { row: null, focus: 0 },
}));

/** The page that is seen. */
export const seen = ({ pages }: Place): Page => pages.at(-1) ?? pages[0];
const COVERS: Readonly<Record<Cover["page"], true>> = { sheet: true, tools: true, own: true, guide: true };
/** Whether a page, or what an address calls one, covers others. */
export const isCover = <P extends { readonly page: string }>(
  page: P,
): page is Extract<P, { readonly page: Cover["page"] }> => Object.hasOwn(COVERS, page.page);
const workPageOf = ({ pages }: Place): WorkPage[] => pages.filter((p) => p.page === "work" || p.page === "elsewhere");
const set = usePlace.setState;

/** Shows an entrance in place of everything else. Whoever calls it has closed the work. */
export const showEntrance = (entrance: Entrance): void => set({ pages: [entrance], over: null });

/** Shows the work, or where it is, over the entrance that it was opened from. */
const showWorkPage = (page: WorkPage): void =>
  set(({ pages: [entrance] }) => ({ pages: [entrance, page], over: null }));

/**
 * A work was opened, or put in place of another one: it is seen, whatever covered the one before, in a section that its
 * kind has.
 */
export function showWork(isProgram: boolean): void {
  showWorkPage({ page: "work" });
  set(({ section, field }) => {
    if (sectionsOf(isProgram).includes(section)) return {};
    // Where the text of a program stands beside its sections, its parts come first.
    const first = !isProgram ? "prompts" : thirdColumn() ? "structure" : "text";
    return { section: first, field: first === section ? field : null };
  });
}

/** No work is open any more: the entrance is seen that it was opened from. */
export const showNoWork = (): void => set(({ pages: [entrance] }) => ({ pages: [entrance], over: null }));

/** Says in place of a work that another tab has it. */
export const showElsewhere = (of: WorkElsewhere): void => showWorkPage({ page: "elsewhere", of });

/** The work that another tab has and that is shown as such; null where none is. */
export const elsewhere = ({ pages }: Place): WorkElsewhere | null =>
  pages.map((p) => (p.page === "elsewhere" ? p.of : null)).find((of) => of !== null) ?? null;

/** Covers of one kind take each other's place: tools and own cycles are tabs of one page. */
const kindOf = ({ page }: Page) => (page === "own" ? "tools" : page);

/** Shows a page over what is seen. One of its kind that lies there already is gone back to. */
export const cover = (page: Cover): void =>
  set((p) => {
    const before = p.pages.findIndex((each) => kindOf(each) === kindOf(page));
    const [entrance, ...rest] = before < 0 ? p.pages : (p.pages.slice(0, before) as unknown as Place["pages"]);
    return { pages: [entrance, ...rest, page], over: null };
  });

/** Closes the cover that is seen; what lies below it is seen again. */
export const uncover = (): void =>
  set((p) => {
    const [entrance, ...rest] = p.pages;
    return isCover(seen(p)) ? { pages: [entrance, ...rest.slice(0, -1)], over: null } : { over: null };
  });

/** Closes every cover and dialog but those named, so that the work is seen, or the entrance where none is open. */
export const uncoverAll = (...but: readonly Cover["page"][]): void =>
  set((p) => ({
    pages: [p.pages[0], ...workPageOf(p), ...p.pages.filter(isCover).filter(({ page }) => but.includes(page))],
    over: null,
  }));

const showOver = (over: Over): void => set({ over });
export const closeOver = (): void => set({ over: null });
export const showWhich = (region: WhichRegion | null = null): void => showOver({ dialog: "which", region });
export const showComparison = (showBlock: ShowBlock, against: OtherText | null = null): void =>
  showOver({ dialog: "comparison", showBlock, against });

export const showSheet = (): void => cover({ page: "sheet" });
export const showGuide = (...path: GuidePath): void => cover({ page: "guide", path });
/** The course where it is the entrance, open or behind a work; null where it is not. */
export const coursePage = ({ pages: [entrance] }: Place) => (entrance.page === "course" ? entrance : null);
/** The page of the guide that lies somewhere in the pages; null where none does. */
export const guidePath = ({ pages }: Place): GuidePath | null =>
  pages.map((p) => (p.page === "guide" ? p.path : null)).find((path) => path !== null) ?? null;

/** Shows the tool table, with this row or the one that was open last. */
export function showTools(row?: string): void {
  if (row !== undefined) openToolRow(row);
  cover({ page: "tools" });
}
export const openToolRow = (row: string | null): void => set((p) => ({ tools: { ...p.tools, row } }));
/** Shows the tools of a kind, the first of them open. */
export const showToolKind = (kind: ToolKind): void => set({ tools: { kind, row: null } });

/** Shows the own cycles, with this row or the one that was open last; `fields`: its first field takes the keyboard. */
export function showOwn(row?: string, fields = false): void {
  set((p) => ({
    own: { row: row ?? p.own.row, focus: fields ? p.own.focus + 1 : seen(p).page === "own" ? p.own.focus : 0 },
  }));
  cover({ page: "own" });
}
export const openOwn = (row: string | null, fields = false): void =>
  set((p) => ({ own: { row, focus: fields ? p.own.focus + 1 : p.own.focus } }));

/** Marks a place that keeps the keyboard while prompts open beside it: the program text, the list of its parts. */
export const KEEPS_KEYBOARD = "data-keeps-keyboard";

/** False while the operator types elsewhere: a field that opens must not take the keyboard away. */
export const mayTakeKeyboard = (): boolean => !document.activeElement?.closest(`[${KEEPS_KEYBOARD}]`);

/** Opens a prompt with the text that stands in it now. */
export const openPrompt = (prompt: string | null, before: string): void =>
  set((p) => ({ section: "prompts", prompt, before, focus: p.focus + 1, field: null }));

/** Opens a prompt beside what is worked with: a field takes the keyboard only where nothing else keeps it. */
export const showPrompt = (prompt: string, before: string): void =>
  set({ section: "prompts", prompt, before, field: null });

export const showSection = (section: WorkSection): void => set({ section, field: null });

/** Shows a section and puts the keyboard into one of its fields. */
export const goToField = (section: WorkSection, field: string): void =>
  set((p) => ({ section, field, focus: p.focus + 1 }));

/** The prompts from their beginning, none of them open. */
export const toFirstPrompt = (): void => set({ section: "prompts", prompt: null, field: null });
