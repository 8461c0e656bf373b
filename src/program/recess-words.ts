import type { Groove } from "../kernel/groove.ts";
import { UNDERCUT_FORMS, type RecessWord, type RecessWords, type Undercut } from "../kernel/undercut.ts";
import { diameter, toRadius } from "../kernel/units.ts";
import type { NamedWord, Statement } from "../nc/statement.ts";
import { programIssue } from "./issue.ts";
import type { Machine } from "./machine.ts";

/** Words that are angles; the others are lengths. */
const ANGLES = ["ANGLE", "FACEANGLE", "ROT"] as const;
/** The words of a recess. */
export const GROOVE_WORDS: readonly RecessWord[] = ["CENTER", "R", "DEPTH", "DIAM", "BREADTH", "ANGLE", "RND", "CHF", "FAR_RND", "FAR_CHF"];
/** The words that each form has; only form E is printed with its words. */
export const UNDERCUT_WORDS: Readonly<Record<Undercut["form"], readonly RecessWord[]>> = {
  E: ["R", "DEPTH", "BREADTH", "ANGLE"], F: ["R", "DEPTH", "BREADTH", "ANGLE", "FACEDEPTH", "FACEANGLE"], H: ["R", "BREADTH", "ANGLE"],
  K: ["R", "DEPTH", "ROT", "ANGLE"], U: ["R", "DEPTH", "BREADTH", "RND", "CHF"], THREAD: ["PITCH", "R", "DEPTH", "BREADTH", "ANGLE"],
};

/** Words by name in mm and degrees; a word that the block can not have is said and left out. */
function wordsOf(
  machine: Machine, words: readonly NamedWord[], allowed: readonly RecessWord[], diameters: readonly RecessWord[], index: number,
): RecessWords {
  const read = words.flatMap(({ name, value }) => {
    const word = allowed.find((w) => w === name);
    if (!word) {
      machine.leaveUnproved(name, index);
      return [];
    }
    const n = machine.number(value, index);
    if (n === null) return [];
    if (ANGLES.some((a) => a === word)) return [[word, n] as const];
    return [[word, diameters.includes(word) ? toRadius(diameter(machine.length(n))) : machine.length(n)] as const];
  });
  return Object.fromEntries(read);
}

/** An undercut or recess of a contour subprogram; null when its form is not known. */
export function recessOf(machine: Machine, s: Extract<Statement, { kind: "undercut" | "groove" }>, index: number): Undercut | Groove | null {
  if (s.kind === "groove") {
    machine.say(programIssue("wordsRecalled", "info", { what: `GRV ${s.form}` }), index);
    const direction = s.form === "AXIAL" ? "axial" : "radial";
    return { kind: "groove", direction, words: wordsOf(machine, s.words, GROOVE_WORDS, direction === "axial" ? ["CENTER", "DIAM"] : ["DIAM"], index) };
  }
  const form = UNDERCUT_FORMS.find((f) => f === s.form.replace(/^TYPE_/, ""));
  if (!form) {
    machine.leaveUnproved(`UDC ${s.form}`, index);
    return null;
  }
  if (form !== "E") machine.say(programIssue("wordsRecalled", "info", { what: `UDC ${s.form}` }), index);
  return { kind: "undercut", form, words: wordsOf(machine, s.words, UNDERCUT_WORDS[form], [], index) };
}
