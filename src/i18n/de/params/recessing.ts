import type { SomeParamTexts } from "../../param-text.ts";

export const recessing = {} satisfies SomeParamTexts;
