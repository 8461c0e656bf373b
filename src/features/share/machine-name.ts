import type { HandedTexts } from "../../i18n/en/handed.ts";
import { machineOf } from "../../program/machine/machine-file.ts";

/** The machine name in the text of a machine file, or the text for none. */
export const nameOfMachine = (words: HandedTexts, text: string): string => machineOf(text)?.name ?? words.noMachine;
