import type { CycleTexts } from "../../cycle-text.ts";

export const recessing = {} satisfies CycleTexts;
