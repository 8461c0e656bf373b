import type { Block } from "../../nc/program.ts";
import { NUMBER_PARAMETER } from "../../nc/value.ts";

const ANY_PARAMETER = new RegExp(String.raw`(?<![A-Z])${NUMBER_PARAMETER}`, "gi");

/** Parameters that blocks set, and those they read. The cycle's own parameters are excluded. */
export function parametersOf(blocks: readonly Block[]): {
  readonly set: ReadonlySet<string>;
  readonly read: ReadonlySet<string>;
} {
  const set = new Set<string>();
  const read = new Set<string>();
  for (const { statement: s, raw } of blocks) {
    if (s.kind === "assign" || s.kind === "assignText") set.add(s.target.toUpperCase());
    const code = raw.replace(/;[^\r\n]*/g, "");
    const used = s.kind === "cycle" ? code.replace(/(^|[\r\n])([ \t]*)Q\d+[ \t]*=/gi, "$1$2 ") : code;
    for (const [name] of used.matchAll(ANY_PARAMETER)) read.add(name.toUpperCase());
  }
  return { set, read };
}

/** A parameter that one operation sets and the other sets or reads: their order matters. */
export function sharedParameter(a: readonly Block[], b: readonly Block[]): string | null {
  const [one, other] = [parametersOf(a), parametersOf(b)];
  for (const name of one.set) if (other.set.has(name) || other.read.has(name)) return name;
  for (const name of other.set) if (one.read.has(name)) return name;
  return null;
}
