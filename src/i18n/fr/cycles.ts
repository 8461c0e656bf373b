import type { CyclesTexts } from "../en/cycles.ts";

export const cycles = {} satisfies CyclesTexts;
