import type { Parameters, Texts } from "./formula.ts";

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

/** What is known beside the values at a moment. */
export type KnownMoment = Readonly<Pick<KnownValues, "bound" | "probed" | "trouble">> & {
  readonly forgotten: ReadonlyMap<string, UnknownReason>;
  readonly held: Texts;
};

/**
 * What is known of the Q parameters while a program runs: a value that nobody knows is another thing than one that was
 * never set.
 */
export class KnownValues {
  private readonly forgotten: Map<string, UnknownReason>;
  private readonly held: Map<string, string>;
  /** Parameters that SQL BIND has tied to a column: a fetch writes into them. */
  readonly bound: Set<string>;
  /** True once a touch probe has run: parameters that hold results are set, nobody here knows to what. */
  probed: boolean;
  /** Why the last value without a number had none. */
  trouble: UnknownReason;

  /** `at`: what was known at a moment of another run. */
  constructor(
    private readonly parameters: Parameters,
    at?: KnownMoment,
  ) {
    this.forgotten = new Map(at?.forgotten);
    this.held = new Map(at?.held);
    this.bound = new Set(at?.bound);
    this.probed = at?.probed ?? false;
    this.trouble = at?.trouble ?? "told";
  }

  get moment(): KnownMoment {
    const { bound, probed, trouble, forgotten, held } = this;
    return { probed, trouble, bound: new Set(bound), forgotten: new Map(forgotten), held: new Map(held) };
  }

  set(name: string, value: number): void {
    this.parameters.set(name, value);
    this.forgotten.delete(name);
  }

  /** What the QS parameters hold. */
  get texts(): Texts {
    return this.held;
  }

  setText(name: string, text: string): void {
    this.held.set(name, text);
    this.forgotten.delete(name);
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
    this.parameters.delete(name);
    this.held.delete(name);
    this.forgotten.delete(name);
  }

  /** A touch probe has run: what its result parameters held before counts no more. */
  probe(): void {
    this.probed = true;
    for (const name of [...this.parameters.keys()]) if (RESULT.test(name)) this.parameters.delete(name);
  }

  /** Takes the local parameters away and gives back what puts them in their place again. */
  withoutLocals(): () => void {
    const [kept, lost] = [
      [...this.parameters].filter(([name]) => LOCAL.test(name)),
      [...this.forgotten].filter(([name]) => LOCAL.test(name)),
    ];
    const clear = () => {
      for (const name of [...this.parameters.keys(), ...this.forgotten.keys()]) if (LOCAL.test(name)) this.unset(name);
    };
    clear();
    return () => {
      clear();
      for (const [name, value] of kept) this.set(name, value);
      for (const [name, reason] of lost) this.forget(name, reason);
    };
  }

  /** Nobody knows what a parameter holds from here on. */
  forget(name: string, reason: UnknownReason = "unproved"): void {
    this.parameters.delete(name);
    this.held.delete(name);
    this.forgotten.set(name, reason);
  }

  /** Why nobody knows what a parameter holds; null when its value is known, or none was ever set. */
  reasonOf(name: string): UnknownReason | null {
    if (this.parameters.has(name) || this.held.has(name)) return null;
    const unknown = KEPT_BY_CONTROL.test(name) || (this.probed && RESULT.test(name));
    return this.forgotten.get(name) ?? (unknown ? "unproved" : null);
  }

  /** True when a parameter holds a value, false when none was ever set, null when nobody knows. */
  isSet(name: string): boolean | null {
    return this.parameters.has(name) || this.held.has(name) ? true : this.reasonOf(name) ? null : false;
  }

  /** True when the last value without a number hangs on a block that was not run. */
  get isUnproved(): boolean {
    return this.trouble === "unproved";
  }
}
