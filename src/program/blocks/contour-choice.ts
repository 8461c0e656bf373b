import { writtenFile } from "./assign.ts";
import type { StatementOf } from "../../nc/statement.ts";
import type { FileName, OutlinePlace } from "../../nc/words.ts";
import { assign, assignText } from "./assign.ts";
import { contourLabels } from "../../nc/blocks/cycle-line.ts";
import type { Machine } from "../state/machine.ts";
import type { ContourSource, JoinedContours } from "../state/modal.ts";
import type { Unit } from "../state/units.ts";

/** One contour, a missing file, several joined contours, or unknown. */
type Found = ContourSource | { readonly missing: string } | JoinedContours | null;

/** Place of an outline; null when the parameter that names it has no value. */
function find(machine: Machine, from: OutlinePlace, unit: Unit, index: number): Found {
  if ("file" in from) {
    const name = writtenFile(machine, from.file, index);
    if (name === null) return null;
    const file = machine.unitOfFile(name, index);
    return file ? { unit: file, label: null } : { missing: name };
  }
  const { label } = from;
  if (typeof label !== "object") return { unit, label };
  const held = label.parameter.startsWith("QS") ? machine.text(label.parameter, index) : machine.number(label, index);
  return held === null ? null : { unit, label: held };
}

function take(machine: Machine, found: Found, what: string, index: number): void {
  if (found === null) return machine.set({ contours: "unknown", contourFile: null });
  if ("joined" in found) return machine.set({ contours: found, contourFile: null });
  if ("unit" in found) return machine.set({ contours: [found], contourFile: null });
  machine.set({ contours: [], contourFile: found.missing });
  machine.log.notSimulated(`${what} "${found.missing}"`, index, "warning");
}

/** A formula of one contour means that contour; a formula of several is a milling rule without meaning in turning. */
function byFormula(s: StatementOf<"contourFormula">, declared: ReadonlyMap<string, Found>, index: number): Found {
  const names = new Set(s.terms.filter((term) => term.startsWith("QC")));
  const [only = ""] = names;
  return names.size === 1 ? (declared.get(only) ?? null) : { joined: s.terms.join(" "), index };
}

/** Contour of a file: the file itself, or the contours it declares, chosen by its last formula. */
function contourOf(machine: Machine, unit: Unit): Found {
  const blocks = unit.program.blocks
    .map((block, i) => ({ s: block.statement, index: unit.from + i }))
    .filter(({ index }) => !machine.isSkipped(index));
  const declarations = blocks.filter(({ s }) => s.kind === "declareContour");
  if (declarations.length === 0) return { unit, label: null };
  const declared = new Map<string, Found>();
  let chosen: Found | undefined;
  for (const { s, index } of blocks) {
    if (s.kind === "assignText") assignText(machine, s, index);
    else if (s.kind === "assign") assign(machine, s, index);
    else if (s.kind === "declareContour") declared.set(s.contour, find(machine, s.from, unit, index));
    else if (s.kind === "contourFormula") {
      chosen = byFormula(s, declared, index);
      declared.set(s.target, chosen);
    }
  }
  if (chosen !== undefined) return chosen;
  const [only] = declared.values();
  return declared.size === 1
    ? (only ?? null)
    : { joined: [...declared.keys()].join(" "), index: declarations[1]?.index ?? unit.from };
}

function takeFile(machine: Machine, file: FileName, what: string, index: number): void {
  const found = find(machine, { file }, machine.unit, index);
  take(machine, found && "unit" in found ? contourOf(machine, found.unit) : found, what, index);
}

/** SEL CONTOUR: the contour of a file; the cycle that needs a missing file reports it. */
export const selectContour = (machine: Machine, s: StatementOf<"selectContour">, index: number): void =>
  takeFile(machine, s.file, "SEL CONTOUR", index);

/** CONTOUR DEF: one area is a contour; several are the areas of a pocket. */
export function contourDefinition(machine: Machine, { areas }: StatementOf<"contourDefinition">, index: number): void {
  const [area] = areas;
  if (areas.length > 1) {
    const joined = areas.map(({ role, number }) => `${role}${number}`).join(" ");
    return take(machine, { joined, index }, "CONTOUR DEF", index);
  }
  if (area && "file" in area.from) return takeFile(machine, area.from.file, "CONTOUR DEF", index);
  take(machine, area ? find(machine, area.from, machine.unit, index) : null, "CONTOUR DEF", index);
}

/** Cycle 14: the contour goes through the labels of its second line one after the other. */
export function contourCycle(machine: Machine, { line, text }: StatementOf<"cycleLine">, index: number): void {
  const found = line === 0 ? [] : contourLabels(text).map((label) => find(machine, { label }, machine.unit, index));
  const sources = found.filter((each): each is ContourSource => each !== null && "unit" in each);
  machine.set({ contourFile: null, contours: sources.length < found.length ? "unknown" : sources });
}
