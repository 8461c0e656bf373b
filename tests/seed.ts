import fc from "fast-check";

/**
 * Random cases are new on every run; the run draws its seed once (vite.config.ts) and prints it, and LAW_SEED=number repeats it. Where
 * only the verdict counts and not the smallest case, LAW_SHRINK=0 ends a law at its first failure.
 */
const seed = Number(process.env["LAW_SEED"]);
if (!Number.isInteger(seed)) throw new Error("LAW_SEED is no whole number");

fc.configureGlobal({ seed, endOnFailure: process.env["LAW_SHRINK"] === "0" });
