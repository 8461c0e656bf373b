import type { HistoryTexts } from "../../i18n/en/history.ts";
import type { OwnList } from "../../program/edits/own-library.ts";
import { fileKey } from "../../program/state/program-files.ts";
import { cellOf } from "../../program/tools/tool-entry.ts";
import type { ToolList } from "../../program/tools/tool-list.ts";
import type { Settings } from "../base/settings/settings.ts";
import { PARTS, SETTINGS, WORKS, workOfDocument } from "./documents.ts";
import { ownRecord } from "./own-store.ts";
import type { HistoryStep, Way } from "./steps.ts";
import { useEditor } from "./store.ts";
import { toolRecord } from "./tool-store.ts";
import { cellWords, joinedWords, listWords, nameWords, valueWords } from "./words-of-list.ts";
import { programWords } from "./words-of-program.ts";
import { workWords } from "./words-of-work.ts";
import type { Work } from "./work.ts";

type States = readonly [before: unknown, after: unknown];

function toolWords([before, after]: States, t: HistoryTexts): string | null {
  const name = (cells: ToolList[number]) => cellOf(cells, "T").trim() || cellOf(cells, "NAME").trim() || t.empty;
  return listWords(
    before as ToolList,
    after as ToolList,
    ({ id }) => id,
    {
      one: (entry) => t.tool(name(entry)),
      many: t.tools,
      whole: t.fields.toolTable,
      added: t.added,
      cells: (a, b) => cellWords(a.cells, b.cells, t),
    },
    t,
  );
}

function ownWords([before, after]: States, t: HistoryTexts): string | null {
  return listWords(
    before as OwnList,
    after as OwnList,
    ({ id }) => id,
    {
      one: ({ number, name }) => t.cycle(number.trim() || name.trim() || t.empty),
      many: t.cycles,
      whole: t.fields.ownCycles,
      added: t.added,
      cells: (a, b) =>
        a.parameters === b.parameters
          ? cellWords({ number: a.number, name: a.name }, { number: b.number, name: b.name }, t, (cell) =>
              cell === "number" ? "" : t.fields.name,
            )
          : null,
    },
    t,
  );
}

interface Listed {
  readonly id: string;
  readonly name: string;
}

function worksWords([before, after]: States, t: HistoryTexts): string | null {
  return listWords(
    before as readonly Listed[],
    after as readonly Listed[],
    ({ id }) => id,
    {
      one: ({ name }) => t.work(name),
      many: t.works,
      whole: t.places.works,
      added: t.added,
      cells: (a, b) => [nameWords("", a.name, b.name, t)],
    },
    t,
  );
}

const SETTING_NAMES: readonly (keyof Settings & keyof HistoryTexts["fields"])[] = [
  "language",
  "theme",
  "motion",
  "presentation",
  "output",
  "machine",
  "material",
  "cutting",
];

function settingsWords([before, after]: States, t: HistoryTexts): string {
  const [was, is] = [before as Partial<Settings>, after as Partial<Settings>];
  const named = SETTING_NAMES.filter((name) => was[name] !== is[name]).map((name) => t.fieldChanged(t.fields[name]));
  if (was.control !== is.control) named.unshift(valueWords(t.fields.control, was.control, is.control, t));
  return named.length === 0 ? t.fieldChanged(t.fields.settings) : joinedWords(named, t);
}

/** Lists of the course by the key of their record: how an entry is named and told from others. */
const COURSE_LISTS: Readonly<
  Record<string, { readonly one: "exercise" | "result"; readonly many: "exercises" | "results" }>
> = {
  "course-tasks": { one: "exercise", many: "exercises" },
  "course-results": { one: "result", many: "results" },
};

/** Title of an exercise in its first language, or the file of a result. */
function courseName(entry: unknown, empty: string): string {
  const { words, file } = entry as {
    readonly words?: Readonly<Record<string, { readonly title?: string } | undefined>>;
    readonly file?: string;
  };
  return Object.values(words ?? {}).find((each) => each?.title)?.title ?? (file || empty);
}

function courseWords(record: string, [before, after]: States, t: HistoryTexts): string | null {
  const list = COURSE_LISTS[record];
  if (!list) return t.fieldChanged(t.fields.course);
  return listWords(
    before as readonly unknown[],
    after as readonly unknown[],
    (entry) => (entry as { readonly id?: string }).id ?? entry,
    {
      one: (entry) => t[list.one](courseName(entry, t.empty)),
      many: t[list.many],
      whole: t.places.course,
      added: t.added,
    },
    t,
  );
}

type NamedPart = { readonly part: { readonly name: string } };

/** Changes of finished parts: the first one of the list is open. */
function partWords([before, after]: States, t: HistoryTexts): string {
  const [was, is] = [before as readonly NamedPart[], after as readonly NamedPart[]];
  const [of] = is.length < was.length ? was : is;
  const name = of?.part.name || t.empty;
  if (is.length === was.length) return t.changed(name, 1);
  return is.length > was.length ? t.added(name, 1) : t.deleted(name, 1);
}

function stateWords({ document, record = document }: HistoryStep, states: States, t: HistoryTexts): string | null {
  if (workOfDocument(document) !== null) return joinedWords(workWords(states[0] as Work, states[1] as Work, t), t);
  switch (record) {
    case toolRecord.key:
      return toolWords(states, t);
    case ownRecord.key:
      return ownWords(states, t);
    case PARTS:
      return partWords(states, t);
    case WORKS:
      return worksWords(states, t);
    case SETTINGS:
      return settingsWords(states, t);
    default:
      return courseWords(record, states, t);
  }
}

/** The change of a step in a text: that of another file than the main program with its name. */
function textWords(step: HistoryStep, way: Way, t: HistoryTexts): string {
  const programs = step.programs?.(way);
  const words = (programs && programWords(...programs, t)) ?? t.fieldChanged(t.fields.text);
  const { program } = useEditor.getState();
  const file = step.file === undefined || !program ? undefined : step.file;
  if (!program || file === undefined || file === fileKey(program.name)) return words;
  const name = program.files?.find((each) => fileKey(each.name) === file)?.name ?? file;
  return t.within(name, words);
}

/**
 * A step in words, from the difference of its document: "Q463 3 → 5", "tool 16 deleted". `way`: the side that it is the
 * next one of.
 */
export function wordsOfStep(step: HistoryStep, way: Way, t: HistoryTexts): string | null {
  if (step.parts) {
    const words = step.parts.map((part) => wordsOfStep(part, way, t)).filter((each) => each !== null);
    return joinedWords([...new Set(words)], t);
  }
  if (step.file !== undefined) return textWords(step, way, t);
  return step.states ? stateWords(step, step.states, t) || null : null;
}
