import fc from "fast-check";

/**
 * The cases of the laws are drawn from a seed that stays the same (vite.config.ts); LAW_SEED=number draws others. A law
 * ends at its first failure and names that case: the smallest one of a set-up or a program may take longer to find than
 * all tests together. LAW_SHRINK=1 looks for it. Nothing ends a law by the time: either all its cases were tried, or
 * one has failed.
 */
const seed = Number(process.env["LAW_SEED"]);
if (!Number.isInteger(seed)) throw new Error("LAW_SEED is no whole number");

fc.configureGlobal({ seed, endOnFailure: process.env["LAW_SHRINK"] !== "1" });
