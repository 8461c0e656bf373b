import type { SomeParamTexts } from "../../param-text.ts";

export const turning = {} satisfies SomeParamTexts;
