import { ncLanguageOf } from "../../i18n/languages.ts";
import { cycleByNumber } from "../../cycles/index.ts";
import { exampleJob, UNSET } from "../../program/job/job.ts";
import { draftOf } from "../../app/document/edits.ts";
import { FIRST_PLACE } from "../../app/fields/dialog/setup-prompts.ts";
import { openPrompt } from "../../app/place/place.ts";
import { startWork } from "../../app/records/keep.ts";
import { useSettings } from "../../app/base/settings/settings.ts";

/** Starts a work with a cycle, with the printed example's values or with empty prompts. */
export function beginCycle(number: number, withExample: boolean): void {
  const cycle = cycleByNumber(number);
  if (!cycle) return;
  const { language, output } = useSettings.getState();
  const example = { ...exampleJob(cycle), ncLanguage: ncLanguageOf(language), output };
  const job = withExample ? example : { ...example, ...UNSET, drafts: {}, contour: [] };
  void startWork(job);
  const [question = null] = Object.keys(cycle.params);
  // A new work starts with the set-up; that of an example is filled in already.
  const first = withExample ? question : FIRST_PLACE;
  openPrompt(first, first === null ? "" : (draftOf(job)[first] ?? ""));
}
