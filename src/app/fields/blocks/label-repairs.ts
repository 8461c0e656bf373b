import { CONTOUR_CYCLE, contourLabels } from "../../../nc/blocks/cycle-line.ts";
import { labelText } from "../../../nc/blocks/words.ts";
import { withBlock } from "../../../nc/edit.ts";
import { blockNumbers, type Program } from "../../../nc/program.ts";
import type { Statement } from "../../../nc/statement.ts";
import { lettersApart } from "../../../nc/typing-slips.ts";
import type { Label } from "../../../nc/words.ts";
import type { Repair } from "./repair.ts";

const isSame = (a: unknown, b: Label): boolean => String(a) === String(b);

/** The labels that a statement refers to. */
function referredTo(s: Statement): readonly unknown[] {
  if (s.kind === "call" || s.kind === "jump") return [s.label];
  return s.kind === "cycleLine" && s.cycle === CONTOUR_CYCLE && s.line > 0 ? contourLabels(s.text) : [];
}

/** The statement with another label in place of a missing one; null where it does not refer to it. */
function referringTo(s: Statement, missing: string, label: Label): Statement | null {
  if (!referredTo(s).some((each) => isSame(each, missing))) return null;
  if (s.kind === "call" || s.kind === "jump") return { ...s, label };
  if (s.kind !== "cycleLine") return null;
  const old = /^\d+$/.test(missing) ? new RegExp(String.raw`(?<!\d)${missing}(?!\d)`) : `"${missing}"`;
  return { ...s, text: s.text.replace(old, () => labelText(label)) };
}

/** Most wrong letters in the name of a label. */
const MOST_APART = 2;

/**
 * Repairs for a label that does not exist: to call a label that nothing else uses, or to give that one the missing
 * name. A label in use helps only where its name is spelt alike.
 */
export function labelRepairs(program: Program, missing: string): readonly Repair[] {
  const { blocks } = program;
  const labels = blocks.flatMap(({ statement: s }, index) =>
    s.kind === "label" && s.label !== 0 ? [{ label: s.label, index }] : [],
  );
  const used = blocks.flatMap(({ statement }) => referredTo(statement));
  const apart = (label: Label) => lettersApart(String(label).toUpperCase(), missing.toUpperCase(), MOST_APART);
  const isUnused = (label: Label) => !used.some((each) => isSame(each, label));
  const isSpeltAlike = (label: Label) => typeof label === "string" && apart(label) <= MOST_APART;
  const nearest = labels
    .filter(({ label }) => isUnused(label) || isSpeltAlike(label))
    .toSorted((a, b) => Number(isUnused(b.label)) - Number(isUnused(a.label)) || apart(a.label) - apart(b.label))[0];
  if (!nearest) return [];
  const { label, index } = nearest;
  const numbers = blockNumbers(program);
  const write = (at: number, text: string, next: () => Program): Repair => ({
    kind: "write",
    text,
    block: String(numbers[at] ?? ""),
    open: at,
    next,
  });
  const referring = blocks.flatMap(({ statement: s }, at) => (referringTo(s, missing, label) ? [at] : []));
  const [first] = referring;
  if (first === undefined) return [];
  const renamed = /^\d+$/.test(missing) ? Number(missing) : missing;
  const called = () =>
    referring.reduce((made, at) => {
      const s = made.blocks[at]?.statement;
      const other = s && referringTo(s, missing, label);
      return other ? withBlock(made, at, other) : made;
    }, program);
  const named = write(index, `LBL ${labelText(renamed)}`, () =>
    withBlock(program, index, { kind: "label", label: renamed }),
  );
  return [write(first, `LBL ${labelText(label)}`, called), ...(isUnused(label) ? [named] : [])];
}
