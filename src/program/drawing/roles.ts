import type { LineRole } from "./drawing.ts";

/** Names of linetypes and layers, in the languages of common programs; as tests of capitals. */
const CENTRE =
  /CENT(ER|RE)|MITTEL|ACHS|\bAXI?S?\b|\bAXES?\b|SYMM|STRICHPUNKT|TRAIT.?MIXTE|ISO(04|08|10)W|中心|轴线|点画线/;
const HIDDEN = /HIDDEN|VERDECKT|UNSICHTBAR|CACH[EÉ]|DASHED|GESTRICHELT|INTERROMPU|ISO(02|03)W|虚线|隐藏/;
const THIN =
  /\bDIM|DIMENSION|BEMA(SS|ß|ẞ)|\bMA(SS|ß)E?\b|\bCOTE|COTATION|HATCH|SCHRAFF|HACHUR|\bTHIN|SCHMAL|GEWINDE|THREAD|FILETAGE|PHANTOM|ISO(05|09|12)W|\bTEXT|TITLE|BORDER|\bFRAME|RAHMEN|CARTOUCHE|CADRE|DEFPOINTS|CONSTRUCT|HILFS|尺寸|标注|剖面|细实线|文字|图框|双点/;

/** Dash and dot, without the second dot of a phantom line. */
function isDashDot(capitals: string): boolean {
  const dot = capitals.lastIndexOf("DOT");
  return dot >= 0 && /DASH[ _-]?$/.test(capitals.slice(Math.max(0, dot - 5), dot));
}

/** Role by the name of a linetype or layer; an unknown name says nothing. */
export function roleOfName(name: string): LineRole {
  const capitals = name.toUpperCase();
  if (CENTRE.test(capitals) || isDashDot(capitals)) return "centre";
  if (HIDDEN.test(capitals)) return "hidden";
  return THIN.test(capitals) ? "thin" : "outline";
}

/** Role by the dashes and gaps of a linetype (ISO 128-2): none is solid, one dash is hidden, long and short is a centre line. */
export function roleOfPattern(dashes: number): LineRole {
  if (dashes <= 1) return "outline";
  return dashes <= 3 ? "hidden" : dashes <= 4 ? "centre" : "thin";
}

/** Narrow lines have half the width of wide ones (ISO 128-2); in between lies the border, as a share. */
const NARROW = 0.6;
/** Outlines have at least this share of the length of all visible lines. */
const LEAST = 0.25;

interface Weighted {
  readonly role: LineRole;
  /** Width in hundredths of a millimetre; null where none is given. */
  readonly weight: number | null;
  readonly length: number;
}

/** Roles with thin lines told from outlines by their widths, as far as a drawing states widths. */
export function rolesByWeight(lines: readonly Weighted[]): LineRole[] {
  const solid = lines.filter((l) => l.role === "outline"),
    total = solid.reduce((sum, l) => sum + l.length, 0),
    widest = solid.reduce((most, l) => Math.max(most, l.weight ?? 0), 0);
  const isNarrow = (l: Weighted) => l.weight !== null && l.weight < widest * NARROW;
  const wide = solid.reduce((sum, l) => sum + (isNarrow(l) ? 0 : l.length), 0);
  const known = lines.map((l) => (l.role === "outline" && wide > total * LEAST && isNarrow(l) ? "thin" : l.role));
  // Where nothing is an outline, the names were no help.
  return known.includes("outline") ? known : known.map((role) => (role === "centre" ? role : "outline"));
}
