import type { Axial, Degrees, Diameter, Feed, Length, Radius } from "../kernel/units.ts";

/**
 * How far a fact can be trusted. A printed for this control; B sibling; L lathe; I inferred; K recalled, unconfirmed.
 */
export type Evidence = "A" | "B" | "L" | "I" | "K1" | "K2" | "K3";

/** The quantity of a value. It belongs to cycle and Q together: Q463 is radial in one cycle and axial in another. */
export type Kind =
  | "choice"
  | "diameter"
  | "oversizeDiameter"
  | "radial"
  | "axial"
  | "axialDepth"
  | "length"
  | "angle"
  | "feed"
  | "count"
  | "factor"
  | "percent"
  | "revolutions";

/** Topics of the recessing cycles only. */
type PlungeTopic = "depthLimit" | "overlap" | "solidFeed" | "retraction" | "dwell" | "comb";

/** Topics of threads only. */
type ThreadTopic =
  | "threadPosition"
  | "threadOrientation"
  | "pitch"
  | "threadDepth"
  | "taperForm"
  | "runIn"
  | "infeedType"
  | "startingAngle"
  | "threadStarts"
  | "airCuts";

/** How the help picture explains a value: by a dimension of the outline, or by an effect of the cycle. */
export type Topic =
  | ThreadTopic
  | PlungeTopic
  | "outline"
  | "element"
  | "clearance"
  | "infeed"
  | "oversizeDiameter"
  | "oversizeZ"
  | "roughingFeed"
  | "finishingFeed"
  | "plungingFeed"
  | "operation"
  | "reverse"
  | "smoothing"
  | "plunging"
  | "limits"
  | "limitDiameter"
  | "limitZ"
  | "direction"
  | "offsetWidth"
  | "depthCompensation"
  | "allowance"
  | "cuttingLines";

/** The value of a kind. A feed is a number or "auto" (FAUTO). */
interface ValueOf {
  choice: number;
  diameter: Diameter;
  oversizeDiameter: Diameter;
  radial: Radius;
  axial: Axial;
  axialDepth: Axial;
  length: Length;
  angle: Degrees;
  feed: Feed | "auto";
  count: number;
  factor: number;
  percent: number;
  revolutions: number;
}

/** Condition under which a value has an effect: another value of its cycle is one of these. */
export interface Condition {
  readonly q: string;
  readonly among: readonly number[];
}

/** Values for roughing only, for finishing only (Q215), and for a limited area only (Q479). */
export const whenRoughing: Condition = { q: "Q215", among: [0, 1] };
export const whenFinishing: Condition = { q: "Q215", among: [0, 2, 3] };
export const whenLimited: Condition = { q: "Q479", among: [1] };

export interface Param<K extends Kind = Kind, T extends string = string> {
  readonly kind: K;
  /** Key of prompt, explanation and NC label in `i18n`. */
  readonly text: T;
  readonly range: readonly [min: number, max: number];
  /** Evidence for the range. */
  readonly rangeEvidence: Evidence;
  /** Value of the printed example. */
  readonly example: number;
  /** NO ENT is allowed: a missing value then counts as `example`-independent 0. */
  readonly optional: boolean;
  readonly incremental: boolean;
  readonly choices?: readonly number[];
  readonly evidence: Evidence;
  /** Number of decimals on the control. */
  readonly decimals: number;
  /** The value has no effect in this cycle (printed as reserved). */
  readonly reserved: boolean;
  /** How the help picture explains it. */
  readonly shown: Topic;
  /** The end of the contour that the value belongs to, in machining direction. */
  readonly place: "start" | "end";
  /** The Q of the element whose size this is: a chamfer or a radius. */
  readonly sizes?: string;
  /** Condition for an effect; the size of an element needs an element. Null: always, as far as is certain. */
  readonly condition: Condition | null;
  /** It is the radius of a rounded corner; 0 leaves the corner sharp. */
  readonly rounds: boolean;
  /** A feed of axes that do not cut: M136 does not make it one per revolution. */
  readonly perMinute: boolean;
  /** It is a dimension of the drawing: a finding may question its sign but never proposes another value. */
  readonly drawn: boolean;
  /**
   * The value that a control fills in where a list written by older software lacks this parameter (K2); null where no
   * list may lack it.
   */
  readonly filledIn: number | null;
}

export type Params = Readonly<Record<string, Param>>;
export type Values<P extends Params> = {
  readonly [Q in keyof P]: P[Q] extends Param<infer K, string> ? ValueOf[K] : never;
};

interface Options {
  evidence?: Evidence;
  rangeEvidence?: Evidence;
  optional?: boolean;
  incremental?: boolean;
  reserved?: boolean;
  decimals?: number;
  shown?: Topic;
  place?: "start" | "end";
  sizes?: string;
  counts?: Condition;
  rounds?: boolean;
  perMinute?: boolean;
  drawn?: boolean;
  filledIn?: number;
}

/** Topics that a drawing shows, and the kinds that are sizes of the shape in a help picture. */
const DRAWN: ReadonlySet<Topic> = new Set<Topic>([
  "element",
  "pitch",
  "taperForm",
  "threadPosition",
  "threadOrientation",
  "threadStarts",
]);
const MEASURES: ReadonlySet<Kind> = new Set<Kind>(["diameter", "radial", "axial", "axialDepth", "length", "angle"]);

function param<K extends Kind, T extends string>(
  kind: K,
  text: T,
  range: readonly [number, number],
  example: number,
  o: Options,
  choices?: readonly number[],
): Param<K, T> {
  return {
    kind,
    text,
    range,
    example,
    rangeEvidence: o.rangeEvidence ?? "A",
    optional: o.optional ?? false,
    incremental: o.incremental ?? false,
    ...(choices ? { choices } : {}),
    evidence: o.evidence ?? "A",
    decimals: o.decimals ?? (kind === "angle" ? 4 : 3),
    reserved: o.reserved ?? false,
    shown: o.shown ?? "outline",
    place: o.place ?? "start",
    ...(o.sizes === undefined ? {} : { sizes: o.sizes }),
    condition: o.counts ?? (o.sizes === undefined ? null : { q: o.sizes, among: [1, 2] }),
    rounds: o.rounds ?? false,
    perMinute: o.perMinute ?? false,
    drawn: o.drawn ?? (DRAWN.has(o.shown ?? "outline") || (MEASURES.has(kind) && (o.shown ?? "outline") === "outline")),
    filledIn: o.filledIn ?? null,
  };
}

/** One of a few printed meanings; texts are `choices` of the text key. */
export const choice = <T extends string>(text: T, choices: readonly number[], example: number, o: Options = {}) =>
  param("choice", text, [Math.min(...choices), Math.max(...choices)], example, o, choices);
type Range = readonly [number, number];
const maker =
  <K extends Kind>(kind: K) =>
  <T extends string>(text: T, range: Range, example: number, o: Options = {}) =>
    param(kind, text, range, example, o);
/** X position, ⌀ mm. */
export const diameterParam = maker("diameter");
/** Oversize on the diameter, ⌀ mm. */
export const oversizeDiameter = maker("oversizeDiameter");
/** A depth across the axis, on the radius, mm. */
export const radial = maker("radial");
/** Z position or signed length along Z, mm. */
export const axialParam = maker("axial");
/** A depth along Z, mm, positive. */
export const axialDepth = maker("axialDepth");
/** A length without direction, mm. */
export const lengthParam = maker("length");
/** Degrees. */
export const angle = maker("angle");
/** mm/rev or mm/min, or FAUTO. */
export const feedParam = maker("feed");
/** A count, without a unit. */
export const countParam = maker("count");
/** A factor, without a unit. */
export const factorParam = maker("factor");
/** A share in percent. */
export const percentParam = maker("percent");
/** Turns of the spindle. */
export const revolutionsParam = maker("revolutions");

/**
 * Tags the parameters of a list that no page we have prints: `K1` clearly recalled, its range probably right. They may
 * come from a cycle whose list is printed.
 */
export const recalled = <const P extends Params>(params: P): P =>
  Object.fromEntries(Object.entries(params).map(([q, p]) => [q, { ...p, evidence: "K1", rangeEvidence: "K2" }])) as P;

/** The same parameter with another value in the example of the list. */
export const exampleOf = <P extends Param>(param: P, example: number): P => ({ ...param, example });

/** Whether a whole list is recalled: this is shown once per cycle, not per parameter. */
export const isRecalled = ({ evidence }: { readonly evidence: Evidence }): boolean => evidence.startsWith("K");
