import type { DialogTexts } from "../en/dialog.ts";

export const dialog = {} satisfies DialogTexts;
