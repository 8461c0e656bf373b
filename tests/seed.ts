import fc from "fast-check";

/**
 * The cases of the laws come from a fixed seed (vite.config.ts); LAW_SEED=number draws others. A law ends at its first
 * failure and reports that case: shrinking a set-up or a program may take longer than all tests together. LAW_SHRINK=1
 * shrinks it. No law has a time limit: either all its cases were tried, or one has failed.
 */
const seed = Number(process.env["LAW_SEED"]);
if (!Number.isInteger(seed)) throw new Error("LAW_SEED is no whole number");

fc.configureGlobal({ seed, endOnFailure: process.env["LAW_SHRINK"] !== "1" });
