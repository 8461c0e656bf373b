import type { HistoryTexts } from "../../i18n/en/history.ts";
import { parse } from "../../nc/parse.ts";
import type { Job } from "../../program/job/job.ts";
import { fileKey } from "../../program/state/program-files.ts";
import { cellWords, listWords, nameWords, valueWords } from "./words-of-list.ts";
import { programWords } from "./words-of-program.ts";
import { filesOf, isProgram, type ProgramWork, type Work, type WorkFile } from "./work.ts";

const UNNAMED: Readonly<Record<string, unknown>> = {};

/** Names of typed values on their own; null for a choice, whose stored value says nothing to an operator. */
const BLANK = { outside: "outside", bore: "bore", length: "length", allowance: "allowance" } as const;
const START = { x: "startX", z: "startZ" } as const;
const SPINDLE: Readonly<Record<string, string>> = { speed: "S", cuttingSpeed: "VC", limit: "SMAX" };

/** Columns of the contour table that are written with their values. */
const CONTOUR: Readonly<Record<string, string>> = { x: "X", z: "Z", r: "R", angle: "AN", length: "LEN", kind: "" };

function jobWords(before: Job, after: Job, t: HistoryTexts): readonly string[] {
  const { fields } = t;
  if (before.cycle !== after.cycle) return [valueWords(fields.cycle, before.cycle, after.cycle, t)];
  const values = (key: "parameters" | "blank" | "start" | "spindle", nameOf: (cell: string) => string | null) =>
    cellWords(before[key] as typeof UNNAMED, after[key] as typeof UNNAMED, t, nameOf);
  const of = (names: Readonly<Record<string, keyof HistoryTexts["fields"]>>) => (cell: string) => {
    const name = names[cell];
    return name === undefined ? null : fields[name];
  };
  const drafts = cellWords(before.drafts[before.cycle] ?? UNNAMED, after.drafts[after.cycle] ?? UNNAMED, t) ?? [];
  const contour =
    before.contour === after.contour
      ? null
      : listWords(
          before.contour,
          after.contour,
          ({ id }) => id,
          {
            one: (_, index) => t.element(index + 1),
            many: t.elements,
            whole: fields.contour,
            added: t.inserted,
            cells: (a, b) =>
              cellWords(
                a as unknown as typeof UNNAMED,
                b as unknown as typeof UNNAMED,
                t,
                (cell) => CONTOUR[cell] ?? null,
              ),
          },
          t,
        );
  return [
    ...drafts,
    ...(values("parameters", (name) => name) ?? []),
    ...(before.tool === after.tool ? [] : [valueWords("T", before.tool, after.tool, t)]),
    ...(values("blank", of(BLANK)) ?? [t.fieldChanged(fields.outside)]),
    ...(values("start", of(START)) ?? []),
    ...(values("spindle", (cell) => SPINDLE[cell] ?? null) ?? [t.fieldChanged(fields.spindle)]),
    ...(before.perRevolution === after.perRevolution ? [] : [after.perRevolution ? t.on("M136") : t.off("M136")]),
    ...(before.rapid === after.rapid ? [] : [valueWords(fields.rapid, before.rapid, after.rapid, t)]),
    ...(contour === null ? [] : [contour]),
  ];
}

function filesWords(before: ProgramWork, after: ProgramWork, t: HistoryTexts): readonly string[] {
  if (fileKey(before.name) !== fileKey(after.name) && filesOf(after).some(({ name }) => name === before.name))
    return [nameWords(t.fields.mainProgram, before.name, after.name, t)];
  const text = (a: WorkFile, b: WorkFile) => (a.text === b.text ? null : programWords(parse(a.text), parse(b.text), t));
  const main = text(before, after);
  const files =
    filesOf(before) === filesOf(after)
      ? null
      : listWords(
          filesOf(before),
          filesOf(after),
          ({ name }) => fileKey(name),
          {
            one: ({ name }) => t.file(name),
            many: t.files,
            whole: t.fields.text,
            added: t.added,
            cells: (a, b) => {
              const words = text(a, b);
              return words === null ? null : [words];
            },
          },
          t,
        );
  return [main, files].filter((each) => each !== null);
}

/** Members of a work that are named, not written: a list, a choice, a table. */
const NAMED = [
  "layout",
  "ncLanguage",
  "output",
  "remarks",
  "material",
  "measured",
  "clamping",
  "task",
  "tools",
  "control",
  "machine",
  "encoding",
] as const;

/** The difference of two states of a work. */
export function workWords(before: Work, after: Work, t: HistoryTexts): readonly string[] {
  const own = isProgram(before)
    ? isProgram(after)
      ? filesWords(before, after, t)
      : []
    : isProgram(after)
      ? []
      : jobWords(before, after, t);
  const [was, is] = [before as unknown as typeof UNNAMED, after as unknown as typeof UNNAMED];
  const skips = was["skipMarked"] === true;
  const isMain = isProgram(before) && isProgram(after) && filesOf(after).some(({ name }) => name === before.name);
  return [
    ...own,
    ...(before.name === after.name || isMain ? [] : [nameWords(t.fields.name, before.name, after.name, t)]),
    ...(skips === (is["skipMarked"] === true) ? [] : [skips ? t.off(t.fields.skipMarked) : t.on(t.fields.skipMarked)]),
    ...NAMED.filter((name) => was[name] !== is[name]).map((name) => t.fieldChanged(t.fields[name])),
  ];
}
