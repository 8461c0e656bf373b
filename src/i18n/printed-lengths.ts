import type { Kind } from "../cycles/params.ts";
import { messageWith } from "./message.ts";
import type { AnyIssue } from "./message-texts.ts";
import { isLength, writer, type Write } from "./write.ts";

/** Quantity of a number in a finding: a length, mm, or an area, mm². */
export type Printed = "length" | "area";

/** A difference that distinguishes numbers without changing a sentence. */
const MARK = 1e-9;

/**
 * The numbers of a finding that its sentence prints as lengths or areas, by their names in its data. The sentence
 * itself shows this: it is formatted with a writer that records its inputs. Speeds, counts and angles are the same in
 * any unit.
 */
export function printedLengths(found: AnyIssue, kind?: Kind): ReadonlyMap<string, Printed> {
  const names = new Map<number, string>();
  const marked = Object.fromEntries(
    Object.entries(found.data).map(([name, value]: [string, unknown], i) => {
      if (typeof value !== "number" || !Number.isFinite(value)) return [name, value];
      const other = value + (i + 1) * MARK;
      names.set(other, name);
      return [name, other];
    }),
  );
  const printed = new Map<string, Printed>();
  const note = (as: Printed, ...values: readonly (number | undefined)[]) => {
    for (const value of values) {
      const name = value === undefined ? undefined : names.get(value);
      if (name !== undefined) printed.set(name, as);
    }
    return "";
  };
  const noted = (value: number) => note("length", value);
  const plain = writer("en", kind);
  const write: Write = {
    ...plain,
    size: noted,
    length: noted,
    diameter: noted,
    signed: noted,
    value: isLength(kind) ? noted : plain.value,
    area: (value) => note("area", value),
    place: (x, z) => note("length", x, z),
    spot: (x, y, z) => note("length", x, y, z),
  };
  messageWith("en", { ...found, data: marked } as AnyIssue, write);
  return printed;
}
