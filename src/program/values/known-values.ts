import { Table, type Changing } from "./grown.ts";

/** Why something is not known: a block was not run, or a fault that was told. */
export type UnknownReason = "unproved" | "told";

/** Parameters that touch probe cycles write their results into. */
const RESULT = /^Q(?:1(?!08|13)\d\d|9[5-9]\d)$/;
/**
 * Parameters that the control itself keeps: what the machine, its tool and its probes say. A program that reads them is
 * no fault.
 */
const KEPT_BY_CONTROL = /^Q1\d\d$/;
/** Of those the two that a program alone can tell: radius of the tool, and unit of the program. */
const [TOOL_RADIUS, UNIT] = ["Q108", "Q113"] as const;
/** Parameters that count in one subprogram or program only. */
const LOCAL = /^QL/;

/** What is known of the Q parameters. Never changed in place. */
export interface Known {
  readonly parameters: Table<string, number>;
  /** What the QS parameters hold. */
  readonly texts: Table<string, string>;
  readonly forgotten: Table<string, UnknownReason>;
  /** Parameters that SQL BIND has tied to a column: a fetch writes into them. */
  readonly bound: ReadonlySet<string>;
  /** True once a touch probe has run: parameters that hold results are set, nobody here knows to what. */
  readonly probed: boolean;
  /** Why the last value without a number had none. */
  readonly trouble: UnknownReason;
}

export const NOTHING_KNOWN: Known = {
  parameters: new Table(),
  texts: new Table(),
  forgotten: new Table(),
  bound: new Set(),
  probed: false,
  trouble: "told",
};

/** Local parameters of a program, and why some of them are not known. */
export interface Locals {
  readonly parameters: ReadonlyMap<string, number>;
  readonly forgotten: ReadonlyMap<string, UnknownReason>;
}

const localsIn = <V>(table: Table<string, V>): ReadonlyMap<string, V> =>
  new Map([...table.toMap()].filter(([name]) => LOCAL.test(name)));

/**
 * What is known of the Q parameters while a program runs: a value that nobody knows is another thing than one that was
 * never set.
 */
export class KnownValues {
  private readonly draft: Changing<Known>;

  constructor(state: Known) {
    this.draft = { ...state };
  }

  get state(): Known {
    return { ...this.draft };
  }

  get parameters(): Known["parameters"] {
    return this.draft.parameters;
  }

  set parameters(parameters: Known["parameters"]) {
    this.draft.parameters = parameters;
  }

  get texts(): Known["texts"] {
    return this.draft.texts;
  }

  get bound(): Known["bound"] {
    return this.draft.bound;
  }

  get trouble(): UnknownReason {
    return this.draft.trouble;
  }

  set trouble(trouble: UnknownReason) {
    this.draft.trouble = trouble;
  }

  set(name: string, value: number): void {
    this.draft.parameters = this.parameters.with(name, value);
    this.draft.forgotten = this.draft.forgotten.with(name, undefined);
  }

  setText(name: string, text: string): void {
    this.draft.texts = this.texts.with(name, text);
    this.draft.forgotten = this.draft.forgotten.with(name, undefined);
  }

  bind(names: readonly string[]): void {
    this.draft.bound = new Set([...this.bound, ...names]);
  }

  /**
   * What the control keeps of the tool that is called, in the unit of the program; null when nobody knows its radius.
   */
  setToolRadius(radius: number | null): void {
    if (radius === null) this.forget(TOOL_RADIUS);
    else this.set(TOOL_RADIUS, radius);
  }

  /** What the control keeps of the program that was started. */
  setUnit(inch: boolean): void {
    this.set(UNIT, inch ? 1 : 0);
  }

  /** Back to a parameter that was never set. */
  unset(name: string): void {
    this.holdNothing(name, undefined);
  }

  /** Nobody knows what a parameter holds from here on. */
  forget(name: string, reason: UnknownReason = "unproved"): void {
    this.holdNothing(name, reason);
  }

  private holdNothing(name: string, reason: UnknownReason | undefined): void {
    this.draft.parameters = this.parameters.with(name, undefined);
    this.draft.texts = this.texts.with(name, undefined);
    this.draft.forgotten = this.draft.forgotten.with(name, reason);
  }

  /** A touch probe has run: what its result parameters held before counts no more. */
  probe(): void {
    const kept = [...this.parameters.toMap()].filter(([name]) => !RESULT.test(name));
    this.draft.probed = true;
    this.draft.parameters = new Table(new Map(kept));
  }

  /** The numbers of local parameters do not count inside a contour. */
  hideLocals(): void {
    for (const name of localsIn(this.parameters).keys()) this.parameters = this.parameters.with(name, undefined);
  }

  /** Takes the local parameters away. */
  takeLocals(): Locals {
    const { parameters, forgotten } = this.draft;
    const locals = { parameters: localsIn(parameters), forgotten: localsIn(forgotten) };
    for (const name of [...locals.parameters.keys(), ...locals.forgotten.keys()]) this.unset(name);
    return locals;
  }

  /** Puts local parameters in the place of those that are there. */
  putLocals({ parameters, forgotten }: Locals): void {
    this.takeLocals();
    parameters.forEach((value, name) => this.set(name, value));
    forgotten.forEach((reason, name) => this.forget(name, reason));
  }

  /** Why nobody knows what a parameter holds; null when its value is known, or none was ever set. */
  reasonOf(name: string): UnknownReason | null {
    if (this.parameters.has(name) || this.texts.has(name)) return null;
    const unknown = KEPT_BY_CONTROL.test(name) || (this.draft.probed && RESULT.test(name));
    return this.draft.forgotten.get(name) ?? (unknown ? "unproved" : null);
  }

  /** True when a parameter holds a value, false when none was ever set, null when nobody knows. */
  isSet(name: string): boolean | null {
    return this.parameters.has(name) || this.texts.has(name) ? true : this.reasonOf(name) ? null : false;
  }

  /** True when the last value without a number hangs on a block that was not run. */
  get isUnproved(): boolean {
    return this.trouble === "unproved";
  }
}
