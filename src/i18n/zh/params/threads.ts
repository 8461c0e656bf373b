import type { SomeParamTexts } from "../../param-text.ts";

export const threads = {} satisfies SomeParamTexts;
