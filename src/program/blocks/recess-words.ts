import { grooveDiameters, GROOVE_WORDS, type Groove } from "../../kernel/contour/groove.ts";
import {
  ANGLE_WORDS,
  UNDERCUT_FORMS,
  UNDERCUT_WORDS,
  type RecessWord,
  type RecessWords,
  type Undercut,
  type UndercutForm,
} from "../../kernel/contour/undercut.ts";
import { diameter, toRadius } from "../../kernel/units.ts";
import type { Statement } from "../../nc/statement.ts";
import type { NamedWord } from "../../nc/words.ts";
import { programIssue } from "../state/issue.ts";
import type { Machine } from "../state/machine.ts";

/** Form of a program word, such as TYPE_E or THREAD; null when there is none. */
export const formOf = (word: string): UndercutForm | null => UNDERCUT_FORMS.find((f) => formWord(f) === word) ?? null;
/** A form as a program writes it. */
export const formWord = (form: string): string => (form === "THREAD" ? form : `TYPE_${form}`);

/** Words by name, in mm and degrees; an invalid word is reported and left out. */
function wordsOf(
  machine: Machine,
  words: readonly NamedWord[],
  allowed: readonly RecessWord[],
  diameters: readonly RecessWord[],
  index: number,
): RecessWords {
  const read = words.flatMap(({ name, value }) => {
    const word = allowed.find((w) => w === name);
    if (!word) {
      machine.log.leaveUnproved(name, index);
      return [];
    }
    const n = machine.number(value, index);
    if (n === null) return [];
    if (ANGLE_WORDS.has(word)) return [[word, n] as const];
    return [[word, diameters.includes(word) ? toRadius(diameter(machine.length(n))) : machine.length(n)] as const];
  });
  return Object.fromEntries(read);
}

/** Undercut or recess of a contour subprogram; null when its form is unknown. */
export function recessOf(
  machine: Machine,
  s: Extract<Statement, { kind: "undercut" | "groove" }>,
  index: number,
): Undercut | Groove | null {
  if (s.kind === "groove") {
    const direction = s.form === "AXIAL" ? "axial" : "radial";
    return {
      kind: "groove",
      direction,
      words: wordsOf(machine, s.words, GROOVE_WORDS, grooveDiameters(direction), index),
    };
  }
  const form = formOf(s.form);
  if (!form) {
    machine.log.leaveUnproved(`UDC ${s.form}`, index);
    return null;
  }
  if (form !== "E") machine.log.report(programIssue("wordsRecalled", "info", { what: `UDC ${s.form}` }), index);
  return { kind: "undercut", form, words: wordsOf(machine, s.words, UNDERCUT_WORDS[form], [], index) };
}
