import type { Texts } from "../../i18n/index.ts";
import type { Language } from "../../i18n/languages.ts";
import { formatNumber } from "../../i18n/number.ts";
import type { Pt } from "../../kernel/point.ts";
import type { Position, Simulation } from "../../sim/simulation.ts";
import { placeText } from "./running.ts";

/** Something to look at in the picture: what was found, or what stays. */
export interface LookAt {
  readonly id: string;
  readonly kind: "finding" | "residual";
  /** Number of a finding, letter of a residual region. */
  readonly mark: string;
  readonly place: Pt;
  /** What and where, in a sentence. */
  readonly line: string;
  /** The moment at which it is to be seen. */
  readonly position: Position;
}

/** A, B … Z, AA … for regions of residual material, beside the numbers of findings. */
export const letterOf = (index: number): string =>
  (index >= 26 ? letterOf(Math.floor(index / 26) - 1) : "") + String.fromCharCode(65 + (index % 26));

/** A rapid is seen before it runs into the material, the others when they have happened. */
const SEEN = { rapidInStock: 0, gouge: 0.999, holderContact: 0.5 } as const;

/** All findings and residual regions of a simulation with their sentences. */
export function placesOf({ findings, proof, steps }: Simulation, t: Texts["lathe"], language: Language): readonly LookAt[] {
  return [
    ...findings.map((f, i): LookAt => {
      const { x, z } = placeText(language, f.place);
      return {
        id: `f${i}`, kind: "finding", mark: String(i + 1), place: f.place,
        line: t.findingLine(t.findingNames[f.kind], x, z, String(f.block)), position: { step: f.step, fraction: SEEN[f.kind] },
      };
    }),
    ...proof.residual.map((r, i): LookAt => {
      const { x, z } = placeText(language, r.place);
      return {
        id: `r${i}`, kind: "residual", mark: letterOf(i), place: r.place,
        line: t.residualLine(formatNumber(language, r.area, 2), x, z, t.reasons[r.reason]), position: { step: steps.length, fraction: 0 },
      };
    }),
  ];
}
