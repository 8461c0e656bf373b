import { cycleByNumber } from "../../cycles/index.ts";
import { ncLanguageOf } from "../../i18n/languages.ts";
import { exampleJob, UNSET, type ContourRow } from "../../program/job/job.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { enterSection } from "../../app/place/place.ts";
import { startWork } from "../../app/records/keep.ts";

/** Starts a program that cuts a contour; its other values are empty. `name`: of the drawing's file. */
export function beginWithContour(number: number, name: string, contour: readonly ContourRow[]): void {
  const cycle = cycleByNumber(number);
  if (!cycle) return;
  const { language, output } = useSettings.getState();
  void startWork({
    ...exampleJob(cycle),
    ...UNSET,
    name: name.replace(/\.[^.]*$/, ""),
    ncLanguage: ncLanguageOf(language),
    output,
    drafts: {},
    contour,
  });
  enterSection("contour");
}
