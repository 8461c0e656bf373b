/** Texts that only Klartext contains: names of cycles and labels of their parameters. */
export interface IsoNames {
  /** Name after the number in the CYCL DEF line; empty for none. */
  cycle(cycle: number): string;
  /** Label behind `;` of one parameter, "Q215"; null or empty for none. */
  label(cycle: number, q: string): string | null;
  /** Cycle 14: title after 14.0, and word before the label numbers of 14.1. */
  readonly contour: { readonly title: string; readonly label: string };
}

/** Names of cycles with numbered lines, which no catalogue contains. */
const OLDER: Readonly<Record<number, string>> = {
  7: "DATUM SHIFT",
  8: "MIRROR IMAGE",
  9: "DWELL TIME",
  10: "ROTATION",
  11: "SCALING",
  12: "PGM CALL",
  13: "ORIENTATION",
  19: "WORKING PLANE",
  32: "TOLERANCE",
};

/** English names; cycles with Q parameters stay without name and labels. */
export const ENGLISH_NAMES: IsoNames = {
  cycle: () => "",
  label: () => null,
  contour: { title: "CONTOUR GEOMETRY", label: "CONTOUR LABEL" },
};

/** The title of an older cycle: from the names, else in English. */
export const olderTitle = (cycle: number, names: IsoNames): string => names.cycle(cycle) || (OLDER[cycle] ?? "");
