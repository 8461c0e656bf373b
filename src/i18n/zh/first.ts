import { chooser } from "./chooser.ts";
import { page } from "./page.ts";

/** What the first screen says, beside the names of the cycles. */
export const first = { page, chooser };
