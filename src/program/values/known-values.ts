import { PersistentMap, type Mutable } from "./persistent.ts";

/** Why a value is unknown: a block not simulated, or a reported fault. */
export type UnknownReason = "unproved" | "told";

/** Result parameters of touch probe cycles. */
const RESULT = /^Q(?:1(?!08|13)\d\d|9[5-9]\d)$/;
/** Parameters set by the control: data of the machine, its tool and its probes. Reading them is no fault. */
const KEPT_BY_CONTROL = /^Q1\d\d$/;
/** The two of them that follow from the program: tool radius, and unit of the program. */
const [TOOL_RADIUS, UNIT] = ["Q108", "Q113"] as const;
/** Parameters local to one subprogram or program. */
const LOCAL = /^QL/;

/** Known Q parameters. Immutable. */
export interface ParameterState {
  readonly parameters: PersistentMap<string, number>;
  /** Texts of the QS parameters. */
  readonly texts: PersistentMap<string, string>;
  readonly unknownReasons: PersistentMap<string, UnknownReason>;
  /** Parameters bound to a column by SQL BIND: a fetch writes into them. */
  readonly bound: ReadonlySet<string>;
  /** True after a touch probe cycle: result parameters have unknown values. */
  readonly probed: boolean;
  /** Why the last value without a number is unknown. */
  readonly lastUnknownReason: UnknownReason;
}

export const NOTHING_KNOWN: ParameterState = {
  parameters: new PersistentMap(),
  texts: new PersistentMap(),
  unknownReasons: new PersistentMap(),
  bound: new Set(),
  probed: false,
  lastUnknownReason: "told",
};

/** Local parameters of a program, and why some are unknown. */
export interface Locals {
  readonly parameters: ReadonlyMap<string, number>;
  readonly forgotten: ReadonlyMap<string, UnknownReason>;
}

const localsIn = <V>(table: PersistentMap<string, V>): ReadonlyMap<string, V> =>
  new Map([...table.toMap()].filter(([name]) => LOCAL.test(name)));

/** Q parameters during a run. An unknown value differs from one never set. */
export class ParameterStore {
  private readonly draft: Mutable<ParameterState>;

  constructor(state: ParameterState) {
    this.draft = { ...state };
  }

  get state(): ParameterState {
    return { ...this.draft };
  }

  get parameters(): ParameterState["parameters"] {
    return this.draft.parameters;
  }

  set parameters(parameters: ParameterState["parameters"]) {
    this.draft.parameters = parameters;
  }

  get texts(): ParameterState["texts"] {
    return this.draft.texts;
  }

  get bound(): ParameterState["bound"] {
    return this.draft.bound;
  }

  get lastUnknownReason(): UnknownReason {
    return this.draft.lastUnknownReason;
  }

  set lastUnknownReason(trouble: UnknownReason) {
    this.draft.lastUnknownReason = trouble;
  }

  set(name: string, value: number): void {
    this.draft.parameters = this.parameters.with(name, value);
    this.draft.unknownReasons = this.draft.unknownReasons.with(name, undefined);
  }

  setText(name: string, text: string): void {
    this.draft.texts = this.texts.with(name, text);
    this.draft.unknownReasons = this.draft.unknownReasons.with(name, undefined);
  }

  bind(names: readonly string[]): void {
    this.draft.bound = new Set([...this.bound, ...names]);
  }

  /** Stores the radius of the called tool, in the program's unit; null when it is unknown. */
  setToolRadius(radius: number | null): void {
    if (radius === null) this.markUnknown(TOOL_RADIUS);
    else this.set(TOOL_RADIUS, radius);
  }

  /** Stores the unit of the main program. */
  setUnit(inch: boolean): void {
    this.set(UNIT, inch ? 1 : 0);
  }

  /** Back to a parameter that was never set. */
  unset(name: string): void {
    this.clearValue(name, undefined);
  }

  /** The value of a parameter is unknown from here on. */
  markUnknown(name: string, reason: UnknownReason = "unproved"): void {
    this.clearValue(name, reason);
  }

  private clearValue(name: string, reason: UnknownReason | undefined): void {
    this.draft.parameters = this.parameters.with(name, undefined);
    this.draft.texts = this.texts.with(name, undefined);
    this.draft.unknownReasons = this.draft.unknownReasons.with(name, reason);
  }

  /** A touch probe has run: earlier values of its result parameters are void. */
  markProbed(): void {
    const kept = [...this.parameters.toMap()].filter(([name]) => !RESULT.test(name));
    this.draft.probed = true;
    this.draft.parameters = new PersistentMap(new Map(kept));
  }

  /** Removes the numbers of local parameters, which do not count inside a contour. */
  hideLocals(): void {
    for (const name of localsIn(this.parameters).keys()) this.parameters = this.parameters.with(name, undefined);
  }

  /** Removes and returns the local parameters. */
  takeLocals(): Locals {
    const { parameters, unknownReasons } = this.draft;
    const locals = { parameters: localsIn(parameters), forgotten: localsIn(unknownReasons) };
    for (const name of [...locals.parameters.keys(), ...locals.forgotten.keys()]) this.unset(name);
    return locals;
  }

  /** Replaces the local parameters. */
  putLocals({ parameters, forgotten }: Locals): void {
    this.takeLocals();
    parameters.forEach((value, name) => this.set(name, value));
    forgotten.forEach((reason, name) => this.markUnknown(name, reason));
  }

  /** Why a parameter is unknown; null when it is known or was never set. */
  reasonOf(name: string): UnknownReason | null {
    if (this.parameters.has(name) || this.texts.has(name)) return null;
    const unknown = KEPT_BY_CONTROL.test(name) || (this.draft.probed && RESULT.test(name));
    return this.draft.unknownReasons.get(name) ?? (unknown ? "unproved" : null);
  }

  /** True when a parameter has a value, false when it was never set, null when unknown. */
  isSet(name: string): boolean | null {
    return this.parameters.has(name) || this.texts.has(name) ? true : this.reasonOf(name) ? null : false;
  }

  /** True when the last value without a number depends on a block not simulated. */
  get isUnproved(): boolean {
    return this.lastUnknownReason === "unproved";
  }
}
