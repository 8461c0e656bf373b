import type { HandedTexts } from "../../i18n/en/handed.ts";
import { machineOf } from "../../program/machine/machine-file.ts";

/** The name of the machine in a text of a machine file, or that there is none. */
export const nameOfMachine = (words: HandedTexts, text: string): string => machineOf(text)?.name ?? words.noMachine;
