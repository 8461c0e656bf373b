import type { NumberStyle } from "./number-text.ts";

/** The writing style of blocks. Every option occurs in printed or real programs. */
export interface Style extends NumberStyle {
  /** The two-space forms of the TNC 640: `L  X+75`, `LBL  2`, `CYCL DEF 200  NAME`. */
  readonly wide: boolean;
  /** ` ~` at the end of each line of a cycle but the last: a control loads no list without it. */
  readonly continued: boolean;
  /** In front of the parameter lines of a cycle. */
  readonly indent: string;
  readonly rapid: "FMAX" | "F MAX";
  /** `LEN 15` and `CCA 180`, as older controls write it. */
  readonly spacedWords: boolean;
  readonly newLine: "\n" | "\r\n" | "\r";
}

export type LayoutName = "tnc640" | "tnc7" | "manual";

const common = { plus: true, decimal: ".", indent: "", rapid: "FMAX", spacedWords: false, newLine: "\n" } as const;

/**
 * Program files of the two controls, and the layout of the TNC 640 manual of 2019, which no control loads: its lists
 * have no ` ~`.
 */
export const LAYOUTS: Readonly<Record<LayoutName, Style>> = {
  tnc640: { ...common, wide: true, continued: true },
  tnc7: { ...common, wide: false, continued: true },
  manual: { ...common, wide: true, continued: false },
};
