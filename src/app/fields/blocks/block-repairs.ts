import { cycleByNumber } from "../../../cycles/index.ts";
import { hasNoEffect, neutralValueOf, type SomeValues } from "../../../cycles/effect.ts";
import { speedAt } from "../../../kernel/time/time.ts";
import { diameter, INCH, roundedDown, toRadius } from "../../../kernel/units.ts";
import { withBlock } from "../../../nc/edit.ts";
import { statementLines } from "../../../nc/print.ts";
import { blockNumbers, type Program } from "../../../nc/program.ts";
import { styleAt } from "../../../nc/read-style.ts";
import type { Statement } from "../../../nc/statement.ts";
import { countsInches } from "../../../program/edits/program-unit.ts";
import { endsAlong } from "../../../program/values/dimension-slips.ts";
import type { FindingEntry } from "../../findings/entry.ts";
import { inProgram, withPrompt } from "./block-prompts.ts";
import { insertion, type Repair } from "./repair.ts";

/** A block with another statement, named by its new text or by the words that change. */
function rewriting(program: Program, at: number, statement: Statement, words?: string): Repair {
  return {
    kind: "write",
    text: words ?? (statementLines(statement, styleAt(program, at))[0] ?? "").trim(),
    block: String(blockNumbers(program)[at] ?? ""),
    next: () => withBlock(program, at, statement),
    open: at,
  };
}

/** The missing first or last block of a program, with name and unit of the other one. */
function frameRepair(program: Program, which: "BEGIN PGM" | "END PGM"): Repair | null {
  const { blocks } = program;
  const isWritten = ({ statement: { kind } }: Program["blocks"][number]) => kind !== "empty" && kind !== "comment";
  const kind = which === "BEGIN PGM" ? "begin" : "end";
  const other = blocks.find(({ statement: s }) => s.kind === "begin" || s.kind === "end")?.statement;
  // A frame block in the middle is in the wrong place; only the operator knows which part is meant.
  if (other?.kind === kind) return null;
  const { name, unit } =
    other?.kind === "begin" || other?.kind === "end" ? other : { name: "PROGRAM", unit: "MM" as const };
  const at = kind === "begin" ? 0 : blocks.findLastIndex(isWritten) + 1;
  return insertion(program, at, [{ kind, name, unit }], at);
}

/** A chamfer or rounding of the largest size that fits between its neighbours. */
function fittingCorner(program: Program, index: number, max: number): Repair | null {
  const s = program.blocks[index]?.statement;
  const size = roundedDown(inProgram(program, max));
  if (size <= 0) return null;
  if (s?.kind === "chamfer") return rewriting(program, index, { ...s, length: size });
  if (s?.kind !== "path" || s.path !== "RND") return null;
  return rewriting(program, index, { ...s, words: { ...s.words, radius: size } });
}

/** Constant speed for a thread: in the spindle block of its own operation, or in a new one before its cycle. */
function constantSpeed(program: Program, index: number, cuttingSpeed: number): Repair | null {
  const before = program.blocks.slice(0, index);
  const last = (kind: Statement["kind"]) => before.findLastIndex(({ statement: s }) => s.kind === kind);
  const [definition, spin] = [last("cycle"), last("spin")];
  const s = program.blocks[definition]?.statement;
  const [active, cycle] = [program.blocks[spin]?.statement, s?.kind === "cycle" ? cycleByNumber(s.cycle) : undefined];
  if (s?.kind !== "cycle" || !cycle) return null;
  const diameters = endsAlong(cycle, "diameter").map((q) => s.parameters.find((p) => p.q === q)?.value);
  const largest = Math.max(...diameters.map((d) => (typeof d === "number" ? d : 0)));
  if (!(largest > 0)) return null;
  const limit = active?.kind === "spin" && typeof active.limit === "number" ? active.limit : 0;
  const across = diameter(countsInches(program) ? largest * INCH : largest);
  const speed = Math.floor(speedAt({ kind: "surface", cuttingSpeed, limit }, toRadius(across)));
  const constant = {
    kind: "spin",
    constantSurface: false,
    cuttingSpeed: null,
    speed,
    limit: null,
    gear: null,
  } as const;
  return spin > last("cycleCall")
    ? rewriting(program, spin, constant, `VCONST:OFF S${speed}`)
    : insertion(program, definition, [constant], index);
}

/** The value for a choice that a list lacks: the one without effect, or that of the printed example. */
function missingChoice(program: Program, index: number, q: string): Repair | null {
  const s = program.blocks[index]?.statement;
  const param = s?.kind === "cycle" ? cycleByNumber(s.cycle)?.params[q] : undefined;
  if (s?.kind !== "cycle" || !param) return null;
  const known: SomeValues = Object.fromEntries(
    s.parameters.map(({ q: name, value }) => [name, typeof value === "number" ? value : undefined]),
  );
  const value = hasNoEffect(param, known) ? neutralValueOf(param) : param.choices ? param.example : null;
  if (value === null) return null;
  const next = () => withPrompt(program, index, q, String(value));
  return { kind: "insert", text: `${q} = ${value}`, block: "", open: index, next };
}

/** Repairs for a block that is missing, or that has one wrong value. */
export function blockRepairs(program: Program, { issue, at }: FindingEntry, index: number): readonly Repair[] {
  const one = ((): Repair | null => {
    switch (issue.code) {
      case "frameMissing":
        return frameRepair(program, issue.data.which);
      case "cornerElementTooLong":
        return fittingCorner(program, index, issue.data.max);
      case "threadSurfaceSpeed":
        return constantSpeed(program, index, issue.data.cuttingSpeed);
      case "missing":
        return at === null ? null : missingChoice(program, index, at);
      default:
        return null;
    }
  })();
  return one ? [one] : [];
}
