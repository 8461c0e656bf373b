import type { Cycle } from "../cycles/define.ts";
import { setupExample, type SetupExample } from "../cycles/setup-example.ts";
import { exampleDraft, type Draft } from "./read-draft.ts";

/** One row of the contour table, as typed: end point, radius, corner element. */
export interface ContourRow {
  readonly id: string;
  readonly kind: "L" | "RND" | "CHF" | "CR";
  /** ⌀ mm, or empty: the coordinate stays as it was. */
  readonly x: string;
  readonly z: string;
  /** Radius of RND and CR, length of CHF, mm. */
  readonly r: string;
  readonly turn: "cw" | "ccw";
  readonly incrementalX: boolean;
  readonly incrementalZ: boolean;
}

/** Cylinder as typed, mm: outside and bore as ⌀, whole length, and how far it reaches in front of Z0. */
export interface BlankDraft {
  readonly outside: string;
  readonly bore: string;
  readonly length: string;
  readonly allowance: string;
}

/** Spindle as typed: rpm for a constant speed; m/min and limit in rpm for a constant cutting speed. */
export interface SpindleDraft {
  readonly mode: "constant" | "surface";
  readonly speed: string;
  readonly cuttingSpeed: string;
  readonly limit: string;
}

/** Everything an operator enters. All typed text is kept as typed; the program text is made from it. */
export interface Job {
  readonly name: string;
  readonly cycle: number;
  /** Values of every cycle that was edited, so that changing the cycle loses nothing. */
  readonly drafts: Readonly<Record<number, Draft>>;
  readonly tool: number;
  readonly blank: BlankDraft;
  /** Tip at the cycle call: ⌀ and Z, mm. */
  readonly start: { readonly x: string; readonly z: string };
  readonly spindle: SpindleDraft;
  /** M136: feeds in mm/rev. */
  readonly perRevolution: boolean;
  /** Rapid rate for the time estimate only, mm/min. */
  readonly rapid: string;
  readonly contour: readonly ContourRow[];
  readonly layout: "tnc640" | "tnc7";
  readonly ncLanguage: "en" | "de" | "fr" | "zh";
}

const row = (id: string, r: SetupExample["contour"][number]): ContourRow =>
  ({ x: "", z: "", r: "", turn: "cw", incrementalX: false, incrementalZ: false, ...r, id });

/** A job that shows the printed example of a cycle. */
export function exampleJob(cycle: Cycle): Job {
  const example = setupExample(cycle.number);
  return {
    name: `${example.name}${cycle.number}`,
    cycle: cycle.number,
    drafts: { [cycle.number]: exampleDraft(cycle) },
    tool: example.tool,
    blank: example.blank,
    start: example.start,
    spindle: { mode: "surface", speed: "800", cuttingSpeed: "180", limit: "2500" },
    perRevolution: true,
    rapid: "10000",
    contour: example.contour.map((r, i) => row(`e${i + 1}`, r)),
    layout: "tnc640",
    ncLanguage: "en",
  };
}
