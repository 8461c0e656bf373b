import type { CycleTexts } from "../../cycle-text.ts";

export const threads = {} satisfies CycleTexts;
