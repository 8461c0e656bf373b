import { chooser } from "./chooser.ts";
import { page } from "./page.ts";
import { typeset } from "./typeset.ts";

/** What the first screen says, beside the names of the cycles. */
export const first = typeset({ page, chooser });
