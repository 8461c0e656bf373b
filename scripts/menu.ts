import type { MenuCycle } from "../src/app/fields/chooser/menu.ts";
import type { Cycle, Outline } from "../src/cycles/define.ts";
import { actingCycles, cuttingCycles } from "../src/cycles/index.ts";
import { unsimulatedNumbers } from "../src/cycles/unsimulated-cycles.ts";
import { isRecalled } from "../src/cycles/params.ts";
import { LANGUAGES } from "../src/i18n/languages.ts";
import { menuWords } from "../src/i18n/menu-words.ts";
import { readText } from "../src/program/values/field.ts";
import { readRows } from "../src/program/job/contour-rows.ts";
import { exampleJob, type Job } from "../src/program/job/job.ts";
import { readDraft } from "../src/program/job/read-draft.ts";
import { SETUP_FIELDS } from "../src/program/job/setup-fields.ts";
import { at } from "../src/kernel/geometry/point.ts";
import { diameter, toRadius } from "../src/kernel/units.ts";
import { pictogram } from "../src/view/pictogram.ts";
import type { Pictogram } from "../src/view/pictogram-box.ts";

/** The contour that a job describes; null where it describes none. */
function outlineOf(cycle: Cycle, job: Job): Outline | null {
  const { values } = readDraft(cycle, job.drafts[cycle.number] ?? {});
  if (!values) return null;
  const [x, z] = [readText(SETUP_FIELDS.startX, job.start.x).value, readText(SETUP_FIELDS.startZ, job.start.z).value];
  const outline = cycle.outline(values, {
    contour: cycle.contour === "free" ? readRows(job.contour).contour.segments : null,
    start: x === null || z === null ? null : at(z, toRadius(diameter(x))),
  });
  return outline.issues.some(({ severity }) => severity === "error") ? null : outline;
}

/**
 * Exchanges two texts, so that an outside example becomes an inside one: the two diameters of the contour, or its only
 * diameter and the start point.
 */
function turnedInside(cycle: Cycle, job: Job): Job {
  const found = Object.entries(cycle.params)
    .filter(([, { kind, shown }]) => kind === "diameter" && shown === "outline")
    .map(([q]) => q);
  const draft = { ...job.drafts[cycle.number] };
  const [first = "", last] = found;
  const xs = job.contour.flatMap(({ x }) => (x === "" ? [] : [Number(x)]));
  const mirrored = (x: string) => (x === "" ? "" : String(Math.min(...xs) + Math.max(...xs) - Number(x)));
  const exchanged = {
    ...draft,
    [first]: last === undefined ? job.start.x : (draft[last] ?? ""),
    ...(last && { [last]: draft[first] ?? "" }),
  };
  return {
    ...job,
    drafts: { [cycle.number]: first === "" ? draft : exchanged },
    start: { ...job.start, x: found.length === 1 ? (draft[first] ?? "") : job.start.x },
    contour: job.contour.map((row) => ({ ...row, x: mirrored(row.x) })),
  };
}

/** The picture of a cycle's example, and its mirrored inside version if that is valid. */
function pictograms(cycle: Cycle): readonly Pictogram[] {
  const example = exampleJob(cycle);
  const [outside, inside] = [example, turnedInside(cycle, example)].map((job) => {
    const outline = outlineOf(cycle, job);
    return outline && pictogram(cycle.group, outline);
  });
  return [...(outside ? [outside] : []), ...(inside?.inside ? [inside] : [])].map(({ inside: _, ...drawn }) => drawn);
}

const row = (cycle: Cycle): MenuCycle => ({
  number: cycle.number,
  group: cycle.group,
  free: cycle.contour === "free",
  recalled: isRecalled(cycle),
  pictograms: cycle.acts ? [] : pictograms(cycle),
});

/** The facts of the catalogue on the first screen: computed when the page is built. */
export const menu: readonly MenuCycle[] = cuttingCycles.map(row);
/** Cycles that are no operation: they can be put into a program. */
const acting = actingCycles.map(row);

/** The modules that the page imports by the names in src/app/fields/chooser/cycle-menu.d.ts, by their ids. */
export function menuModules(): Readonly<Record<string, string>> {
  const id = "virtual:cycle-menu";
  const cases = LANGUAGES.map((language) => `${language}: () => import("${id}/${language}")`);
  return {
    [id]: [
      `export const menu = ${JSON.stringify(menu)};`,
      `export const acting = ${JSON.stringify(acting)};`,
      `export const kept = ${JSON.stringify(unsimulatedNumbers)};`,
      `const words = { ${cases.join(", ")} };`,
      "export const menuWordsOf = async (language) => (await words[language]()).words;",
    ].join("\n"),
    ...Object.fromEntries(
      LANGUAGES.map((language) => [
        `${id}/${language}`,
        `export const words = ${JSON.stringify(menuWords(language))};`,
      ]),
    ),
  };
}
