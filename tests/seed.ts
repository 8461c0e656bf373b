import fc from "fast-check";

/**
 * Every law runs on the same random cases until it is told otherwise, so that a run can be repeated: LAW_SEED takes a
 * number, or "random" to look for new ones (fast-check prints the seed of a failure).
 */
const wanted = process.env["LAW_SEED"];
export const seed = wanted === "random" ? Date.now() % 2 ** 31 : Number(wanted ?? 20261121);

fc.configureGlobal({ seed });
