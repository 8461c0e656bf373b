import type { FreeElement, FromPole, FreeValue } from "../../kernel/free/element.ts";
import type { PlanePoint } from "../../kernel/plane/plane.ts";
import type { Segment } from "../../kernel/geometry/point.ts";
import { degrees, diameter, radians, toRadius } from "../../kernel/units.ts";
import type { StatementOf } from "../../nc/statement.ts";
import type { AxisName, AxisWord, Value, Words } from "../../nc/words.ts";

type Free = StatementOf<"free">;

/** The plane of a free contour: X/Y of a mill, or Z/X of a turning tool with diameters in X, or with radii. */
export type FreePlane = "XY" | "lathe" | "radii";

/** First and second axis of a plane. */
export const AXES = { XY: ["X", "Y"], lathe: ["Z", "X"], radii: ["Z", "X"] } as const satisfies Record<
  FreePlane,
  readonly [AxisName, AxisName]
>;

/** How words become numbers; lengths in the program's unit, from its datum. */
export interface FreeSetting {
  readonly plane: FreePlane;
  /** Start of the first element; null while unknown. */
  readonly from: PlanePoint | null;
  /** Previous segment, for a tangential transition. */
  readonly before: Segment | null;
  readonly number: (value: Value) => number | null;
}

/** A block with its element; null where it is not understood. */
export interface FreeElementRead {
  readonly s: Free;
  readonly element: FreeElement | null;
}

/** State while elements are read: pole, element numbers, start of a closed contour. */
export interface FreeReading {
  readonly setting: FreeSetting;
  readonly pole: PlanePoint | null;
  readonly byBlock: ReadonlyMap<number, number>;
  readonly index: number;
  readonly opened: number;
}

const one = (words: readonly AxisWord[], axis: AxisName) => words.find((w) => w.axis === axis);

export function freePoint(words: readonly AxisWord[], { plane, number }: FreeSetting): PlanePoint | null {
  const [a, b] = AXES[plane].map((axis) => {
    const w = one(words, axis);
    return w && !w.incremental ? number(w.value) : null;
  });
  if (a === null || b === null || a === undefined || b === undefined) return null;
  return { x: a, y: across(b, plane) };
}

/** A coordinate of the second axis as a distance: X is a diameter while turning. */
const across = (n: number, plane: FreePlane): number => (plane === "lathe" ? toRadius(diameter(n)) : n);

/** Thrown for words that are incomplete alone; the element is not read further. */
class Unreadable extends Error {}

/** Words of one block as numbers. Every word that is read counts as understood. */
class FreeReader {
  private readonly asked = new Set<string>();

  constructor(
    private readonly s: Free,
    private readonly r: FreeReading,
  ) {}

  number(value: Value): number {
    const n = this.r.setting.number(value);
    if (n === null) throw new Unreadable();
    return n;
  }

  optional(value: Value | undefined): number | null {
    return value === undefined ? null : this.number(value);
  }

  given(name: string): number | null {
    this.asked.add(name);
    return this.optional(this.s.given.find((w) => w.name === name)?.value);
  }

  /** Element that a word references by block number; the previous one without such a word. */
  reference(name: string): number {
    const block = this.given(name);
    const found = block === null ? this.r.index - 1 : this.r.byBlock.get(block);
    if (found === undefined) throw new Unreadable();
    return found;
  }

  /** A coordinate: absolute, or relative to the referenced point. */
  coordinate(axis: AxisName, isAcross: boolean): FreeValue {
    const word = one(this.s.words.axes, axis);
    const of = this.reference(`R${axis}`);
    if (!word) return null;
    const n = isAcross ? across(this.number(word.value), this.r.setting.plane) : this.number(word.value);
    return word.incremental ? { by: n, of } : { at: n };
  }

  /** A coordinate of the centre. */
  centre(axis: AxisName, isAcross: boolean): FreeValue {
    const scale = (n: number) => (isAcross ? across(n, this.r.setting.plane) : n);
    const [at, by, of] = [this.given(`CC${axis}`), this.given(`ICC${axis}`), this.reference(`RCC${axis}`)];
    return at !== null ? { at: scale(at) } : by !== null ? { by: scale(by), of } : null;
  }

  /** Distance and angle from the pole. */
  polar(far: FreeValue, angle: FreeValue): FromPole | null {
    if (!far && !angle) return null;
    if (!this.r.pole) throw new Unreadable();
    return { pole: this.r.pole, radius: far, angle };
  }

  point(name: string, [first, second]: readonly [AxisName, AxisName]): PlanePoint | null {
    const [x, y] = [this.given(`${name}${first}`), this.given(`${name}${second}`)];
    if ((x === null) !== (y === null)) throw new Unreadable();
    return x === null || y === null ? null : { x, y: across(y, this.r.setting.plane) };
  }

  /** True when every word of the block was read. */
  get isWhole(): boolean {
    return this.s.given.every((w) => this.asked.has(w.name)) && !this.s.words.extra && !this.s.words.linear;
  }
}

const inRadians = (n: number): number => radians(degrees(n));

/** Element of a block; null when something in it is not understood or unknown. */
export function freeElement(s: Free, r: FreeReading): FreeElement | null {
  try {
    return elementFrom(s, r, new FreeReader(s, r));
  } catch (error) {
    if (error instanceof Unreadable) return null;
    throw error;
  }
}

function elementFrom(s: Free, r: FreeReading, read: FreeReader): FreeElement | null {
  const axes = AXES[r.setting.plane];
  const [first, second] = axes;
  const { words } = s;
  const turned = (n: number | null) => (n === null ? null : inRadians(n));
  const polarWord = (w: Words["polarRadius"], of: number, of1: (n: number) => number): FreeValue => {
    const n = w ? of1(read.number(w.value)) : null;
    return n === null ? null : w?.incremental ? { by: n, of } : { at: n };
  };
  const [angle, more, from] = [turned(read.given("AN")), turned(read.given("IAN")), read.reference("RAN")];
  const parallel = read.given("PAR");
  const of = parallel === null ? null : (r.byBlock.get(parallel) ?? null);
  const [distance, beside, far] = [read.given("DP"), read.point("PD", axes), read.given("D")];
  const closing = s.given.some((w) => w.name === "CLSD" && w.value === -1);
  read.given("CLSD");
  const isLine = s.form === "FL" || s.form === "FLT";
  const element: FreeElement = {
    kind: isLine ? "line" : "arc",
    tangent: s.form === "FLT" || s.form === "FCT",
    x: read.coordinate(first, false),
    y: read.coordinate(second, true),
    polar: read.polar(
      polarWord(words.polarRadius, read.reference("RPR"), (n) => n),
      polarWord(words.polarAngle, read.reference("RPA"), inRadians),
    ),
    angle: angle !== null ? { at: angle } : more !== null ? { by: more, of: from } : null,
    length: read.optional(words.length),
    turn: words.turn ?? "ccw",
    radius: read.optional(words.radius),
    centreX: read.centre(first, false),
    centreY: read.centre(second, true),
    centrePolar: read.polar(absolute(read.given("CCPR")), absolute(turned(read.given("CCPA")))),
    sweep: turned(read.optional(words.centreAngle)) || null,
    through: ["P1", "P2", "P3"].flatMap((name) => read.point(name, axes) ?? []),
    distancePoint: beside && far !== null ? { point: beside, distance: Math.abs(far) } : null,
    parallel: of === null ? null : { of, distance: distance === null ? null : Math.abs(distance) },
    closes: closing ? r.opened : null,
  };
  const half =
    (parallel !== null && of === null) ||
    (beside === null) !== (far === null) ||
    (parallel === null && distance !== null);
  const { centreX, centreY, centrePolar, radius: size, sweep } = element;
  const foreign = isLine
    ? [centreX, centreY, centrePolar, size, sweep, words.turn].some((given) => given !== null && given !== undefined)
    : parallel !== null || !words.turn;
  return half || foreign || !read.isWhole ? null : element;
}

const absolute = (n: number | null): FreeValue => (n === null ? null : { at: n });
