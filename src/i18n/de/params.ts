import type { ParamsTexts } from "../en/params.ts";

export const params = {} satisfies ParamsTexts;
