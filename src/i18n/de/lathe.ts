import type { LatheTexts } from "../en/lathe.ts";

export const lathe = {} satisfies LatheTexts;
