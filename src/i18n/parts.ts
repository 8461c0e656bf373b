/* oxlint-disable typescript/consistent-type-imports -- An import would say each name three times. */
import type { Language } from "./languages.ts";
import type { Shape } from "./shape.ts";

/** The files of a language's folder. Each exports only its texts, and is fetched on first use. */
interface English {
  readonly advice: typeof import("./en/advice.ts");
  readonly "better-ways": typeof import("./en/better-ways.ts");
  readonly clamping: typeof import("./en/clamping.ts");
  readonly commands: typeof import("./en/commands.ts");
  readonly compare: typeof import("./en/compare.ts");
  readonly course: typeof import("./en/course.ts");
  readonly "course-drawing": typeof import("./en/course-drawing.ts");
  readonly "course-path": typeof import("./en/course-path.ts");
  readonly "course-set": typeof import("./en/course-set.ts");
  readonly "course-task": typeof import("./en/course-task.ts");
  readonly "course-teach": typeof import("./en/course-teach.ts");
  readonly "cutting-values": typeof import("./en/cutting-values.ts");
  readonly device: typeof import("./en/device.ts");
  readonly drawing: typeof import("./en/drawing.ts");
  readonly "drawing-import": typeof import("./en/drawing-import.ts");
  readonly export: typeof import("./en/export.ts");
  readonly files: typeof import("./en/files.ts");
  readonly find: typeof import("./en/find.ts");
  readonly first: typeof import("./en/first.ts");
  readonly glossary: typeof import("./en/glossary.ts");
  readonly guide: typeof import("./en/guide.ts");
  readonly "guide-blocks": typeof import("./en/guide-blocks.ts");
  readonly "guide-places": typeof import("./en/guide-places.ts");
  readonly handed: typeof import("./en/handed.ts");
  readonly insert: typeof import("./en/insert.ts");
  readonly history: typeof import("./en/history.ts");
  readonly keys: typeof import("./en/keys.ts");
  readonly load: typeof import("./en/load.ts");
  readonly machine: typeof import("./en/machine.ts");
  readonly measure: typeof import("./en/measure.ts");
  readonly mistakes: typeof import("./en/mistakes.ts");
  readonly offline: typeof import("./en/offline.ts");
  readonly output: typeof import("./en/output.ts");
  readonly part: typeof import("./en/part.ts");
  readonly plan: typeof import("./en/plan.ts");
  readonly "plan-comparison": typeof import("./en/plan-comparison.ts");
  readonly "second-side": typeof import("./en/second-side.ts");
  readonly sheet: typeof import("./en/sheet.ts");
  readonly solid: typeof import("./en/solid.ts");
  readonly tables: typeof import("./en/tables.ts");
  readonly threads: typeof import("./en/threads.ts");
  readonly "tool-codes": typeof import("./en/tool-codes.ts");
  readonly "tool-files": typeof import("./en/tool-files.ts");
  readonly "tool-foreign": typeof import("./en/tool-foreign.ts");
  readonly "tool-sheets": typeof import("./en/tool-sheets.ts");
  readonly undercuts: typeof import("./en/undercuts.ts");
  readonly which: typeof import("./en/which.ts");
  readonly workplace: typeof import("./en/workplace.ts");
}

export type PartName = keyof English;
/** The texts of a part: the shape of the English ones. */
export type PartTexts<N extends PartName> = Shape<English[N][keyof English[N]]>;

type File = Readonly<Record<string, unknown>>;
const first = import.meta.glob<File>("./*/first.ts");
/** The texts of the other languages: a page that shows one language knows the files of no other. */
const others = import.meta.glob<Readonly<Record<string, () => Promise<File>>>>("./*/parts.ts", { import: "parts" });

/** Fetches a part of the texts of a language. */
export async function loadTexts<N extends PartName>(language: Language, name: N): Promise<PartTexts<N>> {
  const load =
    name === "first" ? first[`./${language}/first.ts`] : (await others[`./${language}/parts.ts`]?.())?.[`./${name}.ts`];
  if (!load) throw new Error(`No texts: ${language} ${name}`);
  return Object.values(await load())[0] as PartTexts<N>;
}
