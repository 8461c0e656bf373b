import type { Hand } from "../iso-codes/code-part.ts";
import { IN_MM, type LengthUnit } from "../../kernel/units.ts";

/*
 * What the file of another system says about one tool, in the words of the trade. Each format fills these facts from
 * its own properties (`fusion.ts`, `iso13399.ts` …); `foreign-tool.ts` makes the columns of the tool table from them.
 */

/** Kind of a tool that a file names. */
export type FileToolKind =
  | "turning"
  | "grooving"
  | "parting"
  | "threading"
  | "drill"
  | "center"
  | "tap"
  | "reamer"
  | "mill";
/** Side that a tool works on. */
export type WorkSide = "outside" | "inside" | "face";

/** Why a value is proposed; everything else stands in the file. */
export const PROPOSALS = [
  "outsideAssumed",
  "handAssumed",
  "middleAssumed",
  "leftBar",
  "kindFromName",
  "kindFromProperties",
  "recessAssumed",
  "sideFromName",
  "fromCode",
  "circleAssumed",
  "unsureStyle",
  "edgeTurned",
  "wedgeFromAngles",
  "widthFromDiameter",
  "bodyAsCentre",
  "numberFree",
  "numberTaken",
] as const;
export type ProposalReason = (typeof PROPOSALS)[number];

/** A value with the property it stands in, as written there; `why` if it is a proposal. */
export interface Fact<T> {
  readonly value: T;
  readonly from: string;
  readonly why?: ProposalReason;
}

/** Lengths in mm, angles in degrees. */
interface FactValues {
  readonly number: number;
  readonly name: string;
  readonly kind: FileToolKind;
  readonly finishing: boolean;
  readonly side: WorkSide;
  readonly hand: Hand;
  /** TO of the control. */
  readonly orientation: number;
  /** Letter of ISO 1832. */
  readonly shape: string;
  /** Included angle of the insert at its corner. */
  readonly point: number;
  readonly nose: number;
  readonly circle: number;
  readonly edge: number;
  /** Angle from the feed direction to the main edge. */
  readonly setting: number;
  readonly width: number;
  /** Limits that the maker states (`LIMIT_NUMBERS`). */
  readonly depth: number;
  readonly axialFrom: number;
  readonly axialTo: number;
  readonly partOff: number;
  readonly bore: number;
  readonly pointLength: number;
  /** Included angle of a thread profile. */
  readonly profile: number;
  readonly pitch: number;
  /** Diameter of a drill, tap or mill. */
  readonly cutter: number;
  readonly drillPoint: number;
  readonly flute: number;
  readonly lengthZ: number;
  readonly lengthX: number;
  /** Width of a shank, diameter of a bar. */
  readonly shank: number;
  /** From the back of the shank, or the axis of the bar, to the tip (f1 of ISO 5610, WF of ISO 13399). */
  readonly reach: number;
  /** From the tip to the shank along it, and from the tip to its end. */
  readonly head: number;
  readonly overall: number;
}
export type FactName = keyof FactValues;
export type Facts = { readonly [N in FactName]?: Fact<FactValues[N]> };

/** One tool of a file. */
export interface FileTool {
  /** Its name in the file, for people. */
  readonly label: string;
  readonly facts: Facts;
  /** Texts that may contain ISO codes of insert and holder. */
  readonly texts: readonly string[];
  /** Properties with a value that no column takes. */
  readonly unused: readonly string[];
}

/** Why an item of a file is no tool of the table. */
export const REFUSALS = [
  "holder",
  "probe",
  "otherMachine",
  "noColumn",
  "kindUnknown",
  "unknownList",
  "fileMissing",
  "nothingKnown",
] as const;
export type RefusalReason = (typeof REFUSALS)[number];

/** An item that is not imported; `kind` is its kind as written in the file. */
export interface RefusedItem {
  readonly label: string;
  readonly why: RefusalReason;
  readonly kind: string;
}

/** A value of a property; a unit of its own wins over that of the file. */
export interface FileProperty {
  readonly value: string | number | boolean;
  readonly unit?: LengthUnit;
}
export type FileProperties = ReadonlyMap<string, FileProperty>;

/** Names of the properties that state a fact; the first one with a usable value counts. */
export type Vocabulary = { readonly [N in FactName]?: readonly string[] };

const LENGTHS = [
  ...(["nose", "circle", "edge", "width", "depth", "pitch", "cutter", "flute", "lengthZ", "lengthX"] as const),
  ...(["shank", "reach", "head", "overall"] as const),
  ...(["axialFrom", "axialTo", "partOff", "bore", "pointLength"] as const),
];
const ANGLES = ["point", "setting", "profile", "drillPoint"] as const;
/** These may be 0; a 0 elsewhere means that nothing is stated. */
const MAY_BE_ZERO: readonly FactName[] = ["nose", "lengthZ", "lengthX"];
const LARGEST = 100_000;

const UNITS: readonly (readonly [RegExp, LengthUnit])[] = [
  [/^(?:mm|millimet(?:er|re)s?)$/i, "mm"],
  [/^(?:in|inch(?:es)?|"|″|'')$/i, "inch"],
];
/** Unit of length by its name; null for others. */
export const unitOf = (name: string): LengthUnit | null => UNITS.find(([form]) => form.test(name.trim()))?.[1] ?? null;

const MEASURE = /^([+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d{1,3})?)\s*(\S{0,12})$/;

/** Number of a property and its unit, the one behind the number before that of the property. Both decimal signs are read. */
export function measureOf({ value, unit }: FileProperty): {
  readonly value: number | null;
  readonly unit?: LengthUnit;
} {
  const found = typeof value === "number" ? ["", String(value), ""] : MEASURE.exec(String(value).slice(0, 64).trim());
  const number = found ? Number((found[1] ?? "").replace(",", ".")) : NaN;
  const own = unitOf(found?.[2] ?? "") ?? unit;
  return { value: Math.abs(number) <= LARGEST ? number : null, ...(own && { unit: own }) };
}

/** A length or angle on the grid of the table, 0.0001. */
export const onGrid = (n: number) => Math.round(n * 10_000) / 10_000 + 0;

/** Reads properties and remembers which were used. */
export class PropertyReader {
  private readonly used = new Set<string>();
  /** Whether a length without a unit was read: then the unit of the file counts. */
  unitAsked = false;
  private readonly properties: FileProperties;
  private readonly unit: LengthUnit;

  constructor(properties: FileProperties, unit: LengthUnit) {
    this.properties = properties;
    this.unit = unit;
  }

  private first<T>(names: readonly string[], read: (property: FileProperty) => T | null): Fact<T> | undefined {
    for (const name of names) {
      const property = this.properties.get(name);
      if (property === undefined) continue;
      const value = read(property);
      if (value === null) continue;
      this.used.add(name);
      return { value, from: written(name, property) };
    }
    return undefined;
  }

  text(...names: readonly string[]): Fact<string> | undefined {
    return this.first(names, ({ value }) => (String(value).trim() === "" ? null : String(value).trim().slice(0, 200)));
  }

  /** A length in mm. */
  length(names: readonly string[], mayBeZero = false): Fact<number> | undefined {
    let isInch = false;
    const found = this.first(names, (property) => {
      const { value, unit } = measureOf(property);
      if (value === null || !(value > 0 || (mayBeZero && value === 0))) return null;
      if (unit === undefined) this.unitAsked = true;
      isInch = unit === undefined && this.unit === "inch" && value !== 0;
      return onGrid(value * IN_MM[unit ?? this.unit]);
    });
    return found && isInch ? { ...found, from: `${found.from} in` } : found;
  }

  /** An angle in degrees, or any other plain number. */
  number(...names: readonly string[]): Fact<number> | undefined {
    return this.first(names, (property) => {
      const { value } = measureOf(property);
      return value !== null && value > 0 ? value : null;
    });
  }

  /** Facts that are plain sizes. */
  sizes(vocabulary: Vocabulary): Facts {
    const lengths = LENGTHS.map((name) => [name, this.length(vocabulary[name] ?? [], MAY_BE_ZERO.includes(name))]);
    const angles = ANGLES.map((name) => [name, this.number(...(vocabulary[name] ?? []))]);
    return Object.fromEntries([...lengths, ...angles].filter(([, fact]) => fact !== undefined)) as Facts;
  }

  /** Uses properties that say nothing about geometry. */
  pass(...names: readonly string[]): void {
    for (const name of names) this.used.add(name);
  }

  /** Names of the properties with a value that were not used. */
  get unused(): readonly string[] {
    return [...this.properties]
      .filter(([name, { value }]) => !this.used.has(name) && value !== false && value !== "" && value !== 0)
      .map(([name]) => name.replace(/^geometry\./, ""));
  }
}

/** A property as it stands in the file. */
function written(name: string, { value, unit }: FileProperty): string {
  const plain = name.replace(/^geometry\./, "");
  const shown = typeof value === "number" ? String(onGrid(value)) : String(value).trim().slice(0, 60);
  const own = unit === undefined || unitOf(String(value).replace(/^[\s\d.,+\-eE]+/, "")) !== null ? "" : ` ${unit}`;
  return `${plain} ${shown}${own}`;
}
