import type { Parameters } from "./formula.ts";

/** Why something is not known: a block was not run, or a fault that was told. */
export type UnknownReason = "unproved" | "told";

/** Parameters that touch probe cycles write their results into. */
const RESULT = /^Q1\d\d$/;

/** What is known of the Q parameters while a program runs: a value that nobody knows is another thing than one that was never set. */
export class KnownValues {
  private readonly forgotten = new Map<string, UnknownReason>();
  /** True once a touch probe has run: parameters that hold results are set, nobody here knows to what. */
  probed = false;
  /** Why the last value without a number had none. */
  trouble: UnknownReason = "told";

  constructor(private readonly parameters: Parameters) {}

  set(name: string, value: number): void {
    this.parameters.set(name, value);
    this.forgotten.delete(name);
  }

  /** Nobody knows what a parameter holds from here on. */
  forget(name: string, reason: UnknownReason = "unproved"): void {
    this.parameters.delete(name);
    this.forgotten.set(name, reason);
  }

  /** Why nobody knows what a parameter holds; null when its value is known, or none was ever set. */
  reasonOf(name: string): UnknownReason | null {
    if (this.parameters.has(name)) return null;
    return this.forgotten.get(name) ?? (this.probed && RESULT.test(name) ? "unproved" : null);
  }

  /** True when a parameter holds a value, false when none was ever set, null when nobody knows. */
  isSet(name: string): boolean | null {
    return this.parameters.has(name) ? true : this.reasonOf(name) ? null : false;
  }

  /** True when the last value without a number hangs on a block that was not run. */
  get isUnproved(): boolean {
    return this.trouble === "unproved";
  }
}
