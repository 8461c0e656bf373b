import { create } from "zustand";

/** What is known of the copy of the page on this device, and of a newer version. */
export interface Version {
  /** Whether the whole page is here for use without a network; `failed` tries again when there is one. */
  readonly kept: "impossible" | "coming" | "kept" | "failed";
  /** A newer version that waits for its turn, or one that another tab put in use. */
  readonly newer: "none" | "ready" | "elsewhere";
  /** The bar that says so was put off. */
  readonly later: boolean;
  /** When the server was last asked for a newer version, ms of the clock. */
  readonly lookedAt: number;
  /** What came of it. */
  readonly looked: "no" | "looking" | "coming" | "newest" | "unreachable" | "unfinished";
}

/** A page of the build, in a browser that can keep it. */
export const canKeep = import.meta.env.PROD && typeof navigator !== "undefined" && "serviceWorker" in navigator;

export const useVersion = create<Version>(() => ({
  kept: canKeep ? "coming" : "impossible",
  newer: "none",
  later: false,
  looked: "no",
  lookedAt: 0,
}));
