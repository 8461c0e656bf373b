import { defineActing } from "./acting.ts";

/** Cancels cycle 800; has no effect where 800 had none. */
export const c801 = defineActing({ number: 801, evidence: "K1", params: {}, acts: { neutral: {} } });
