import type { KeyPlace } from "../base/key-list.ts";
import { create } from "zustand";
import type { Site } from "../../cycles/shape-request.ts";
import type { LessonPage } from "../../course/progress.ts";
import type { Ring, Segment } from "../../kernel/geometry/point.ts";
import { focusPart, isFocusChosen } from "../base/focus-guard.ts";
import { thirdColumn } from "../base/use-media.ts";

/** The sections of each kind of work, in the order of their tabs. */
const SECTIONS = {
  cycle: ["prompts", "setup", "contour", "findings", "program"],
  program: ["text", "block", "structure", "findings"],
} as const;
/** The kinds of work, each with its layout: one cycle by its prompts, or a whole program. */
export type WorkKind = keyof typeof SECTIONS;
export const sectionsOf = (kind: WorkKind): readonly WorkSection[] => SECTIONS[kind];
/** The sections of a job; one at a time where there is little room. */
export type JobSection = (typeof SECTIONS.cycle)[number];
/** The sections of a program: its text, the dialog of one block, the list of its structure. */
export type ProgramSection = (typeof SECTIONS.program)[number];
export type WorkSection = JobSection | ProgramSection;
export type ToolKind = "turning" | "milling";

/** Entrance pages, shown while no work is open. */
export type Entrance =
  | { readonly page: "start" }
  | { readonly page: "works" }
  /** The list of lessons where `lesson` is null. */
  | { readonly page: "course"; readonly lesson: string | null; readonly at: LessonPage };

/**
 * A requested work that is not shown: it is open in another tab, that tab took it over, or it was open here when the
 * page died.
 */
export interface WorkElsewhere {
  readonly work: string;
  readonly name: string;
  readonly cause: "isOpen" | "wasTaken" | "died";
}
/** The page of an open work. */
export type WorkPage = { readonly page: "work" } | { readonly page: "elsewhere"; readonly of: WorkElsewhere };

/** Path of a page of the guide, after "#/": ["guide", "812", "Q463"], ["glossary", "infeed"]. */
export type GuidePath = readonly string[];
/** A page over others, with a button back to them. */
export type Cover =
  | { readonly page: "sheet" }
  | { readonly page: "plan" }
  | { readonly page: "tools" }
  | { readonly page: "own" }
  | { readonly page: "guide"; readonly path: GuidePath };
export type Page = Entrance | WorkPage | Cover;

/** A section of an open work's finished contour, with the stock. */
export interface WhichRegion {
  readonly contour: readonly Segment[];
  readonly first: number;
  readonly last: number;
  readonly site: Site;
  /** The stock at the end of the work. */
  readonly stock: readonly Ring[];
  /** Default choice of the stock. */
  readonly initialStock: "solid" | "now";
}
/** Shows a block of the open work: by its index in one of its files (null: the main program), and by its number. */
export type ShowBlock = (file: string | null, index: number, number: number) => void;
/** Another version of the shown file, with its name. */
export interface OtherText {
  readonly name: string;
  readonly text: string;
}
/**
 * A dialog over the page: which cycle makes a shape (`region` null: any), the open program compared with another text or
 * with better ways, its drawing, or sharing it.
 */
export type Over =
  | { readonly dialog: "which"; readonly region: WhichRegion | null }
  | { readonly dialog: "comparison"; readonly showBlock: ShowBlock; readonly against: OtherText | "better" | null }
  | { readonly dialog: "keys"; readonly place: KeyPlace }
  | { readonly dialog: "drawing" | "share" }
  | { readonly dialog: "commands" };

/** Where the operator is. It is no part of the work, so undo does not touch it. */
export interface Place {
  /** Stack of pages: an entrance, perhaps the work, perhaps covers. The last one is shown. */
  readonly pages: readonly [Entrance, ...(WorkPage | Cover)[]];
  readonly over: Over | null;
  readonly section: WorkSection;
  /** Q number of the open prompt; null when the dialog is at its end. */
  readonly prompt: string | null;
  /** Text of the open prompt as it was when it opened, for Escape. */
  readonly before: string;
  /** Counts up to focus the open field. */
  readonly focus: number;
  /** Field of the set-up or contour that gets the focus. */
  readonly field: string | null;
  /**
   * Id of the open row of the tool table (a deleted one counts as the first of its kind), and the kind shown while none
   * is open.
   */
  readonly tools: { readonly row: string | null; readonly kind: ToolKind };
  /** Id of the open own cycle; `focus` counts up to focus its first field. */
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

/** The page on top. */
export const shownPage = ({ pages }: Place): Page => pages.at(-1) ?? pages[0];
const COVERS: Readonly<Record<Cover["page"], true>> = { sheet: true, plan: true, tools: true, own: true, guide: true };
/** Whether a page or an address is a cover. */
export const isCover = <P extends { readonly page: string }>(
  page: P,
): page is Extract<P, { readonly page: Cover["page"] }> => Object.hasOwn(COVERS, page.page);
const workPageOf = ({ pages }: Place): WorkPage[] => pages.filter((p) => p.page === "work" || p.page === "elsewhere");
const set = usePlace.setState;

/** Shows an entrance in place of everything else. The caller has closed the work. */
export const showEntrance = (entrance: Entrance): void => set({ pages: [entrance], over: null });

/** Shows the page of a work over the entrance that it was opened from. */
const showWorkPage = (page: WorkPage): void =>
  set(({ pages: [entrance] }) => ({ pages: [entrance, page], over: null }));

/** Shows a work that was opened or replaced: covers close, in a section that its kind has. */
export function showWork(kind: WorkKind): void {
  showWorkPage({ page: "work" });
  set(({ section, field }) => {
    if (sectionsOf(kind).includes(section)) return {};
    // With the text in its own column, the structure comes first.
    const first = kind === "cycle" ? "prompts" : thirdColumn() ? "structure" : "text";
    return { section: first, field: first === section ? field : null };
  });
}

/** Shows the entrance again, since no work is open. */
export const showNoWork = (): void => set(({ pages: [entrance] }) => ({ pages: [entrance], over: null }));

/** Shows that another tab has the work. */
export const showElsewhere = (of: WorkElsewhere): void => showWorkPage({ page: "elsewhere", of });

/** The shown work that another tab has, or null. */
export const workElsewhere = ({ pages }: Place): WorkElsewhere | null =>
  pages.map((p) => (p.page === "elsewhere" ? p.of : null)).find((of) => of !== null) ?? null;

/** Covers of one kind replace each other: tools and own cycles are tabs of one page. */
const kindOf = ({ page }: Page) => (page === "own" ? "tools" : page);

/** Shows a page over the present one. If one of its kind is in the stack, the stack goes back to it. */
export const cover = (page: Cover): void =>
  set((p) => {
    const before = p.pages.findIndex((each) => kindOf(each) === kindOf(page));
    const [entrance, ...rest] = before < 0 ? p.pages : (p.pages.slice(0, before) as unknown as Place["pages"]);
    return { pages: [entrance, ...rest, page], over: null };
  });

/** Closes the cover on top. */
export const uncover = (): void =>
  set((p) => {
    const [entrance, ...rest] = p.pages;
    return isCover(shownPage(p)) ? { pages: [entrance, ...rest.slice(0, -1)], over: null } : { over: null };
  });

/** Closes every dialog and cover except those named, so that the work shows, or the entrance if none is open. */
export const uncoverAll = (...but: readonly Cover["page"][]): void =>
  set((p) => ({
    pages: [p.pages[0], ...workPageOf(p), ...p.pages.filter(isCover).filter(({ page }) => but.includes(page))],
    over: null,
  }));

const showOver = (over: Over): void => set({ over });
export const closeOver = (): void => set({ over: null });
export const showWhich = (region: WhichRegion | null = null): void => showOver({ dialog: "which", region });
export const showComparison = (showBlock: ShowBlock, against: OtherText | "better" | null = null): void =>
  showOver({ dialog: "comparison", showBlock, against });
/** Shows the workshop drawing of the open work, or shares it. */
export const showDrawing = (): void => showOver({ dialog: "drawing" });
export const showShare = (): void => showOver({ dialog: "share" });
export const showCommands = (): void => showOver({ dialog: "commands" });
export const showKeys = (place: KeyPlace): void => showOver({ dialog: "keys", place });

export const showSheet = (): void => cover({ page: "sheet" });
export const showPlan = (): void => cover({ page: "plan" });
export const showGuide = (...path: GuidePath): void => cover({ page: "guide", path });
/** The page of the course if it is the entrance, also behind a work; else null. */
export const coursePage = ({ pages: [entrance] }: Place) => (entrance.page === "course" ? entrance : null);
/** The page of the guide in the stack, or null. */
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

/** Shows the own cycles, with this row or the last open one; `fields`: focuses its first field. */
export function showOwn(row?: string, fields = false): void {
  set((p) => ({
    own: { row: row ?? p.own.row, focus: fields ? p.own.focus + 1 : shownPage(p).page === "own" ? p.own.focus : 0 },
  }));
  cover({ page: "own" });
}
export const openOwn = (row: string | null, fields = false): void =>
  set((p) => ({ own: { row, focus: fields ? p.own.focus + 1 : p.own.focus } }));

/** Marks an area that keeps the focus while prompts open beside it: the program text, its structure, an exercise. */
export const KEEPS_KEYBOARD = "data-keeps-keyboard";

/** False while the operator types in such an area: a field that opens must not take the focus. */
export const mayTakeKeyboard = (): boolean =>
  !isFocusChosen() || !document.activeElement?.closest(`[${KEEPS_KEYBOARD}]`);

/** Lets the next field that opens take the focus, also out of such an area. */
export function releaseKeyboard(): void {
  const { activeElement } = document;
  if (activeElement instanceof HTMLElement && !mayTakeKeyboard()) activeElement.blur();
}

/** Opens and focuses a prompt with its present text. */
export const openPrompt = (prompt: string | null, before: string): void =>
  set((p) => ({ section: "prompts", prompt, before, focus: p.focus + 1, field: null }));

/** Opens a prompt without moving the focus out of an area that keeps it. */
export const showPrompt = (prompt: string, before: string): void =>
  set({ section: "prompts", prompt, before, field: null });

export const showSection = (section: WorkSection): void => set({ section, field: null });

/** Shows a section and moves the focus into it, also out of an area that keeps it. */
export function enterSection(section: WorkSection): void {
  showSection(section);
  focusPart(`.panel-${section}`, () => {
    releaseKeyboard();
    set((p) => ({ focus: p.focus + 1 }));
  });
}

/** Shows a section and focuses one of its fields. */
export const goToField = (section: WorkSection, field: string): void =>
  set((p) => ({ section, field, focus: p.focus + 1 }));

/** Shows the prompts from the beginning, none of them open. */
export const toFirstPrompt = (): void => set({ section: "prompts", prompt: null, field: null });
