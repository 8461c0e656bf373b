import { toolCodes as codesDe } from "../../src/i18n/de/tool-codes.ts";
import { toolFiles as filesDe } from "../../src/i18n/de/tool-files.ts";
import { toolCodes as codesEn } from "../../src/i18n/en/tool-codes.ts";
import { toolFiles as filesEn } from "../../src/i18n/en/tool-files.ts";
import { toolCodes as codesFr } from "../../src/i18n/fr/tool-codes.ts";
import { toolFiles as filesFr } from "../../src/i18n/fr/tool-files.ts";
import type { Language } from "../../src/i18n/languages.ts";
import type { ToolWords } from "../../src/i18n/load-tool-words.ts";
import { toolCodes as codesZh } from "../../src/i18n/zh/tool-codes.ts";
import { toolFiles as filesZh } from "../../src/i18n/zh/tool-files.ts";

/** The texts that come with the tool table. */
export const toolWords: Readonly<Record<Language, ToolWords>> = {
  en: { codes: codesEn, files: filesEn },
  de: { codes: codesDe, files: filesDe },
  fr: { codes: codesFr, files: filesFr },
  zh: { codes: codesZh, files: filesZh },
};
