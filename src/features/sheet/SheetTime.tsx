import type { SheetTexts } from "../../i18n/en/sheet.ts";
import type { Run } from "../../program/state/run-types.ts";
import { timeCauses, timeContents } from "../../app/findings/effect/time-contents.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import type { SheetWords } from "./sheet-words.ts";

/** The running time, its parts, and what it includes. */
export function SheetTime({
  run,
  t,
  words,
}: {
  readonly run: Run;
  readonly t: SheetTexts;
  readonly words: SheetWords;
}) {
  const { time } = useTexts("machine");
  const language = useSettings((s) => s.language);
  const causes = timeCauses(time, run).map(([name, seconds]) => `${name} ${words.time(seconds)}`);
  return (
    <>
      {t.estimate(words.time(run.seconds))}
      <span className="sheet-time">{[causes.join(", "), ...timeContents(time, run, language)].join(". ")}</span>
    </>
  );
}
