import type { HelpTexts } from "../en/help.ts";

export const help = {} satisfies HelpTexts;
