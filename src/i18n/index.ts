import { de } from "./de/index.ts";
import { deTables } from "./de/tables.ts";
import type { ApproachTexts } from "./en/approach.ts";
import type { ChooserTexts } from "./en/chooser.ts";
import type { ContourTexts } from "./en/contour.ts";
import type { CyclesTexts } from "./cycle-text.ts";
import type { DialogTexts } from "./en/dialog.ts";
import type { HelpTexts } from "./en/help.ts";
import type { EditorTexts } from "./en/editor.ts";
import type { FindingsTexts } from "./en/findings.ts";
import { en } from "./en/index.ts";
import { enTables } from "./en/tables.ts";
import type { LatheTexts } from "./en/lathe.ts";
import type { MessagesTexts } from "./message-texts.ts";
import type { OperationsTexts } from "./en/operations.ts";
import type { OwnTexts } from "./en/own.ts";
import type { PageTexts } from "./en/page.ts";
import type { ParamsTexts } from "./param-text.ts";
import type { SetupTexts } from "./en/setup.ts";
import type { ToolsTexts } from "./en/tools.ts";
import { fr } from "./fr/index.ts";
import { frTables } from "./fr/tables.ts";
import type { Language } from "./languages.ts";
import { zh } from "./zh/index.ts";
import { zhTables } from "./zh/tables.ts";

/** The texts of one screen language that the workplaces show, by area. A text missing in a language is a compile error. */
export interface Texts {
  readonly page: PageTexts;
  readonly chooser: ChooserTexts;
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

/** Those of the tables that the device keeps, tools and own cycles: they come when one of them is shown. */
export interface TableTexts {
  readonly tools: ToolsTexts;
  readonly own: OwnTexts;
}

const all: Readonly<Record<Language, Texts & TableTexts>> = {
  en: { ...en, ...enTables },
  de: { ...de, ...deTables },
  fr: { ...fr, ...frTables },
  zh: { ...zh, ...zhTables },
};

/** All texts of a screen language. */
export const texts = (language: Language): Texts & TableTexts => all[language];
