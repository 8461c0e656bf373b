import type { ApproachTexts } from "./en/workplace/approach.ts";
import type { ChooserTexts } from "./en/first/chooser.ts";
import type { ContourTexts } from "./en/workplace/contour.ts";
import type { CyclesTexts } from "./cycle-text.ts";
import type { DialogTexts } from "./en/workplace/dialog.ts";
import type { HelpTexts } from "./en/workplace/help.ts";
import type { EditorTexts } from "./en/workplace/editor.ts";
import type { FindingsTexts } from "./en/workplace/findings.ts";
import type { LatheTexts } from "./en/workplace/lathe.ts";
import type { MessagesTexts } from "./message-texts.ts";
import type { OperationsTexts } from "./en/workplace/operations.ts";
import type { OwnTexts } from "./en/tables/own.ts";
import type { HelpMenuTexts } from "./en/first/help.ts";
import type { PageTexts } from "./en/first/page.ts";
import type { StartTexts } from "./en/first/start.ts";
import type { ParamsTexts } from "./param-text.ts";
import type { SetupTexts } from "./en/workplace/setup.ts";
import type { ToolsTexts } from "./en/tables/tools.ts";
import { LANGUAGES, type Language } from "./languages.ts";

/** Texts of the first screen, except the names of the cycles. */
export interface FirstTexts {
  readonly page: PageTexts;
  readonly chooser: ChooserTexts;
  readonly start: StartTexts;
  readonly helpMenu: HelpMenuTexts;
}

/**
 * The texts of one screen language that the workplaces show, by area. A text missing in a language is a compile error.
 */
export interface Texts extends FirstTexts {
  readonly dialog: DialogTexts;
  readonly setup: SetupTexts;
  readonly lathe: LatheTexts;
  readonly help: HelpTexts;
  readonly contour: ContourTexts;
  readonly editor: EditorTexts;
  readonly approach: ApproachTexts;
  readonly findings: FindingsTexts;
  readonly messages: MessagesTexts;
  readonly operations: OperationsTexts;
  readonly params: ParamsTexts;
  readonly cycles: CyclesTexts;
}

/** Texts of the stored tables, tools and own cycles: loaded when one of them is shown. */
export interface TableTexts {
  readonly tools: ToolsTexts;
  readonly own: OwnTexts;
}

const workplaces = import.meta.glob<Texts>("./*/workplace.ts", { eager: true, import: "workplace" });
const tables = import.meta.glob<TableTexts>("./*/tables.ts", { eager: true, import: "tables" });

const all = Object.fromEntries(
  LANGUAGES.map((language) => [
    language,
    { ...workplaces[`./${language}/workplace.ts`], ...tables[`./${language}/tables.ts`] },
  ]),
) as Readonly<Record<Language, Texts & TableTexts>>;

/** All texts in a screen language, synchronously: for reports, scripts and tests. */
export const texts = (language: Language): Texts & TableTexts => all[language];
