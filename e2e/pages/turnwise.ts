import { expect, type Browser, type Locator, type Page } from "@playwright/test";
import type { TableTexts, Texts } from "../../src/i18n/index.ts";
import type { Language } from "../../src/i18n/languages.ts";
import { ClampingPage } from "./clamping.ts";
import type { Context } from "./context.ts";
import { Comparison } from "./comparison.ts";
import { ContourTable } from "./contour-table.ts";
import { Course } from "./course.ts";
import { Dialog } from "./dialog.ts";
import { Effect } from "./effect.ts";
import { OwnCycles } from "./own-cycles.ts";
import { Menus } from "./menus.ts";
import { Sharing } from "./sharing.ts";
import { Lathe } from "./lathe.ts";
import { Findings } from "./findings.ts";
import { ProgramEditor } from "./program-editor.ts";
import { ProgramText } from "./program-text.ts";
import { SettingsPage } from "./settings.ts";
import { Setup } from "./setup.ts";
import { SetupSheetPage } from "./sheet.ts";
import { Start } from "./start.ts";
import { Teaching } from "./teaching.ts";
import { TaskPanel } from "./task.ts";
import { ToolTable } from "./tools.ts";
import { TYPING } from "../../src/app/base/waits.ts";
import { loadWords, words } from "./words.ts";
import { WorksList } from "./works.ts";

export interface Options {
  /** Screen language; English by default. */
  readonly language?: Language;
  /** Time stands still until `lathe.advance(milliseconds)`; a string is the local start time: "2026-11-21T08:00". */
  readonly heldClock?: boolean | string;
  /** Seed of all random values in a fresh context: names of works, addresses, ids in files. */
  readonly seed?: number;
  readonly theme?: "light" | "dark";
  /** Size of the window. */
  readonly viewport?: { readonly width: number; readonly height: number };
  /** A device with a touch screen: needs `open(browser, …)`, since a page cannot get one later. */
  readonly touch?: boolean;
}

/** The strip is quiet if nothing is calculated and nothing changes for this long: longer than any pause in typing, ms. */
const QUIET = TYPING.longRest + TYPING.rest;

/** A page for the options: of the given browser in a context of its own, or the given one. */
async function pageFor(on: Page | Browser, { viewport, touch = false }: Options): Promise<Page> {
  if ("newContext" in on) {
    const context = await on.newContext({ ...(viewport && { viewport }), hasTouch: touch });
    return context.newPage();
  }
  if (touch)
    throw new Error("A page without a touch screen cannot get one: use Turnwise.open(browser, { touch: true }).");
  if (viewport) await on.setViewportSize(viewport);
  return on;
}

/** The whole page by role and accessible name, in any of its languages. Names come from the page's own texts. */
export class Turnwise {
  readonly start: Start;
  readonly dialog: Dialog;
  readonly setup: Setup;
  readonly contour: ContourTable;
  readonly effect: Effect;
  readonly findings: Findings;
  readonly lathe: Lathe;
  readonly program: ProgramText;
  readonly editor: ProgramEditor;
  readonly settings: SettingsPage;
  readonly tools: ToolTable;
  readonly own: OwnCycles;
  readonly works: WorksList;
  readonly menus: Menus;
  readonly sharing: Sharing;
  readonly clamping: ClampingPage;
  readonly comparison: Comparison;
  readonly sheet: SetupSheetPage;
  readonly course: Course;
  readonly teaching: Teaching;
  readonly task: TaskPanel;
  readonly t: Texts & TableTexts;

  private constructor(
    readonly page: Page,
    readonly language: Language,
  ) {
    this.t = { ...words(language, "workplace"), ...words(language, "tables") };
    const context: Context = { page, t: this.t, language };
    this.start = new Start(context);
    this.dialog = new Dialog(context);
    this.setup = new Setup(context);
    this.contour = new ContourTable(context);
    this.effect = new Effect(context);
    this.findings = new Findings(context);
    this.lathe = new Lathe(context);
    this.program = new ProgramText(context);
    this.editor = new ProgramEditor(context);
    this.settings = new SettingsPage(context);
    this.tools = new ToolTable(context);
    this.own = new OwnCycles(context);
    this.works = new WorksList(context);
    this.menus = new Menus(context);
    this.sharing = new Sharing(context);
    this.clamping = new ClampingPage(context);
    this.comparison = new Comparison(context);
    this.sheet = new SetupSheetPage(context);
    this.course = new Course(context);
    this.teaching = new Teaching(context);
    this.task = new TaskPanel(context);
  }

  /**
   * Opens the page as a first-time visitor of this language would see it: in the page of the test, or in a page of its
   * own in a browser, which `turnwise.page.context().close()` closes.
   */
  static async open(on: Page | Browser, options: Options = {}): Promise<Turnwise> {
    const { language = "en", heldClock = false, seed, theme = "light" } = options;
    const [page] = await Promise.all([pageFor(on, options), loadWords(language)]);
    await page.emulateMedia({ colorScheme: theme });
    const search = new URLSearchParams();
    if (heldClock !== false) search.set("clock", heldClock === true ? "manual" : heldClock);
    if (seed !== undefined) search.set("seed", String(seed));
    await page.goto(search.size === 0 ? "./" : `./?${search}`);
    const turnwise = new Turnwise(page, language);
    if (language !== "en") await new Turnwise(page, "en").settings.chooseLanguage(language);
    return turnwise;
  }

  /** Loads the texts of a language, for `at`; `open` does so itself. */
  static load(language: Language): Promise<void> {
    return loadWords(language);
  }

  /** The page as it is now, in a language it already shows and whose texts are loaded. */
  static at(page: Page, language: Language = "en"): Turnwise {
    return new Turnwise(page, language);
  }

  /** Shows one of the tabbed panels; on a wide screen some are always visible. */
  async show(section: "prompts" | "setup" | "contour" | "findings" | "program"): Promise<void> {
    const tab = this.page.getByRole("tab", {
      name: new RegExp(`^${section === "findings" ? this.t.findings.title : this.t.page[section]}`),
    });
    await this.page.getByRole("tablist").first().waitFor();
    if (await tab.count()) await tab.click();
  }

  /**
   * Waits until what the strip shows below the work belongs to its present values, with or without findings: nothing is
   * being calculated, and nothing is still to come after a pause in typing.
   */
  async calculated(): Promise<void> {
    const strip = this.page
      .getByRole("region", { name: this.t.page.effect.title, exact: true })
      .or(this.page.getByRole("region", { name: this.t.editor.total, exact: true }));
    const rested = async () => {
      await expect(strip).toHaveAttribute("aria-busy", "false");
      return strip.textContent();
    };
    await expect(async () => {
      const before = await rested();
      await this.page.waitForTimeout(QUIET);
      expect(await rested()).toBe(before);
    }).toPass();
  }

  /** Undo or redo in the header; its name goes on with what it changes. */
  historyButton(way: "undo" | "redo"): Locator {
    return this.page.getByRole("banner").getByRole("button", { name: new RegExp(`^${this.t.page[way]}(?: ?[:：]|$)`) });
  }

  async undo(): Promise<void> {
    await this.historyButton("undo").click();
  }

  async redo(): Promise<void> {
    await this.historyButton("redo").click();
  }
}
