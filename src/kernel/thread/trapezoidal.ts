import { rounded } from "../units.ts";
import type { NamedThread, StandardId, ThreadTolerance } from "./named-thread.ts";
import { preferred } from "./preferred-numbers.ts";
import { TRAPEZOIDAL_ANGLE, trapezoidalClearance } from "./profiles.ts";
import { isPlausible, startsOf, type ThreadStandard } from "./standard.ts";
import type { TypedName } from "./typed-name.ts";

/** Diameter and usual pitch (ISO 2902, DIN 103-2); the finer and the coarser one behind, where the table has them. */
const SIZES: readonly (readonly [diameter: number, usual: number, ...others: number[]])[] = [
  [8, 1.5],
  [9, 2, 1.5],
  [10, 2, 1.5],
  [11, 2, 3],
  [12, 3, 2],
  [14, 3, 2],
  [16, 4, 2],
  [18, 4, 2],
  [20, 4, 2],
  [22, 5, 3, 8],
  [24, 5, 3, 8],
  [26, 5, 3, 8],
  [28, 5, 3, 8],
  [30, 6, 3, 10],
  [32, 6, 3, 10],
  [34, 6, 3, 10],
  [36, 6, 3, 10],
  [38, 7, 3, 10],
  [40, 7, 3, 10],
  [42, 7, 3, 10],
  [44, 7, 3, 12],
  [46, 8, 3, 12],
  [48, 8, 3, 12],
  [50, 8, 3, 12],
  [52, 8, 3, 12],
  [55, 9, 3, 14],
  [60, 9, 3, 14],
  [65, 10, 4, 16],
  [70, 10, 4, 16],
  [75, 10, 4, 16],
  [80, 10, 4, 16],
  [85, 12, 4, 18],
  [90, 12, 4, 18],
  [95, 12, 4, 18],
  [100, 12, 4, 20],
];

/** Tr 40 x 7; Tr 40 x 14 P7; Tr 40 x 14 (P7); Tr 40. The first number behind the x is the lead. */
export const leadName = (symbol: string) =>
  new RegExp(`^${symbol} ?(\\d+(?:\\.\\d+)?)(?:x(\\d+(?:\\.\\d+)?)(?: ?\\(?p(\\d+(?:\\.\\d+)?)\\)?)?)?$`);

/** The size that such a name says; `usual`: pitch of a diameter where none is typed. */
export function sizeWithLead(match: RegExpExecArray | null, usual: (diameter: number) => number | undefined) {
  if (!match) return null;
  const nominal = Number(match[1]);
  const lead = match[2] === undefined ? usual(nominal) : Number(match[2]);
  const made = lead === undefined ? null : startsOf(lead, match[3] === undefined ? undefined : Number(match[3]));
  return made && isPlausible(nominal, made.pitch) ? { nominal, ...made } : null;
}

/** Name of a size with its lead: Tr40×7, Tr40×14 P7. */
export const nameWithLead = (symbol: string, nominal: number, pitch: number, starts: number): string =>
  `${symbol}${nominal}×${rounded(pitch * starts)}${starts > 1 ? ` P${pitch}` : ""}`;

/** What all threads with a lead have in common. */
export const leadFacts = (
  id: StandardId,
  symbol: string,
  { nominal, pitch, starts }: { readonly nominal: number; readonly pitch: number; readonly starts: number },
  typed: TypedName,
): Pick<NamedThread, "standard" | "name" | "nominal" | "pitch" | "starts" | "leftHand" | "taper" | "side"> => ({
  standard: id,
  name: nameWithLead(symbol, nominal, pitch, starts),
  nominal,
  pitch,
  starts,
  leftHand: typed.leftHand,
  taper: 0,
  side: typed.outside && !typed.inside ? "outside" : typed.inside && !typed.outside ? "inside" : null,
});

/**
 * Pitch, mm: deviation e of d2, tolerance of grade 4 of d and of D1, then of grade 7 of d2 by range of the diameter up to
 * 11.2, 22.4, 45, 90 and 180 mm (0: none); µm (ISO 2903). D2 has the tolerance five steps of R 40 wider.
 */
const TOLERANCES: readonly (readonly [P: number, e: number, Td: number, TD1: number, ...byDiameter: number[]])[] = [
  [1.5, 67, 150, 190, 170],
  [2, 71, 180, 236, 190, 200],
  [3, 85, 236, 315, 212, 224, 250, 265],
  [4, 95, 300, 375, 0, 265, 0, 300, 315],
];
const RANGES = [11.2, 22.4, 45, 90, 180] as const;
const INSIDE = 5;

/** Middle class 7e and 7H; null where we have no figures to compare. */
function toleranceOf(nominal: number, pitch: number) {
  const row = TOLERANCES.find(([P]) => P === pitch);
  const tolerance = row?.[4 + RANGES.findIndex((upTo) => nominal <= upTo)];
  return row && tolerance ? { e: row[1], Td: row[2], TD1: row[3], T: tolerance } : null;
}

/** Metric trapezoidal threads, single and multiple start. */
export const trapezoidal: ThreadStandard = {
  id: "trapezoidal",
  documents: "ISO 2901 … 2904 (DIN 103)",
  evidence: "L",
  names: SIZES.map(([d, usual]) => `Tr${d}×${usual}`),
  read(typed) {
    const size = sizeWithLead(leadName("tr").exec(typed.size), (d) => SIZES.find(([each]) => each === d)?.[1]);
    if (!size || (typed.outside && typed.outside !== "7e") || (typed.inside && typed.inside !== "7H")) return null;
    const { nominal, pitch } = size;
    const ac = trapezoidalClearance(pitch);
    const [major, minor] = [rounded(nominal + ac + ac), rounded(nominal - pitch - ac - ac)];
    const [flank, core] = [rounded(nominal - pitch / 2), rounded(nominal - pitch)];
    const found = toleranceOf(nominal, pitch);
    // A class that we have no figures for is not filled under its name.
    if (!found && (typed.outside || typed.inside)) return null;
    const outside: ThreadTolerance | undefined = found
      ? {
          name: "7e",
          crest: [rounded(nominal - found.Td / 1000), nominal],
          pitch: [rounded(flank - (found.e + found.T) / 1000), rounded(flank - found.e / 1000)],
        }
      : undefined;
    const inside: ThreadTolerance | undefined = found
      ? {
          name: "7H",
          crest: [core, rounded(core + found.TD1 / 1000)],
          pitch: [flank, rounded(flank + preferred(found.T, INSIDE) / 1000)],
        }
      : undefined;
    return {
      ...leadFacts("trapezoidal", "Tr", size, typed),
      listed: SIZES.some(([d, ...pitches]) => d === nominal && pitches.includes(pitch)),
      angle: TRAPEZOIDAL_ANGLE,
      flatRoot: true,
      outside: { crest: nominal, pitch: flank, root: minor, ...(outside && { tolerance: outside }) },
      inside: { crest: core, pitch: flank, root: major, ...(inside && { tolerance: inside }) },
    };
  },
};
