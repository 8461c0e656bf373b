import { defineActing } from "./acting.ts";

/** Takes back what the cycle before this number has fitted; where that changed nothing, this does not either. */
export const c801 = defineActing({ number: 801, evidence: "K1", params: {}, acts: { neutral: {} } });
