import type { CycleTexts } from "../../cycle-text.ts";

export const special = {} satisfies CycleTexts;
