import { create } from "zustand";

/** The browser's offer to install the page, as Chromium makes it. */
export interface InstallOffer extends Event {
  readonly prompt: () => Promise<unknown>;
}

/** State of the page's copy on this device, and of a newer version. */
export interface Version {
  /** Whether the whole page is stored for use offline; `failed` retries when the network is back. */
  readonly kept: "impossible" | "coming" | "kept" | "failed";
  /** A newer version that is ready, or that another tab has activated. */
  readonly newer: "none" | "ready" | "elsewhere";
  /** The update bar was postponed. */
  readonly later: boolean;
  /** When the server was last asked for a newer version, ms of the clock. */
  readonly lookedAt: number;
  /** Held back until somebody presses Install; null where the browser has none, or the page is installed. */
  readonly install: InstallOffer | null;
  /** Result of that check. */
  readonly looked: "no" | "looking" | "coming" | "newest" | "unreachable" | "unfinished";
}

/** A built page in a browser that can store it. */
export const canKeep = import.meta.env.PROD && typeof navigator !== "undefined" && "serviceWorker" in navigator;

export const useVersion = create<Version>(() => ({
  kept: canKeep ? "coming" : "impossible",
  newer: "none",
  later: false,
  looked: "no",
  lookedAt: 0,
  install: null,
}));
