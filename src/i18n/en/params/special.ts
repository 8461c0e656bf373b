import type { SomeParamTexts } from "../../param-text.ts";

export const special = {} satisfies SomeParamTexts;
