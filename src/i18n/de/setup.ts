import type { SetupTexts } from "../en/setup.ts";

export const setup = {} satisfies SetupTexts;
