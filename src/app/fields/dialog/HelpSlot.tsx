import { useMemo } from "react";
import type { CycleNumber } from "../../../cycles/index.ts";
import { exampleJob } from "../../../program/job/job.ts";
import { cycleGivens } from "../../calculation/cycle-givens.ts";
import { HelpPicture } from "../../pictures/help/HelpPicture.tsx";
import type { Numbers } from "../../../view/help/lettering.ts";
import { useDeferredUntilPaint } from "../../base/typing.ts";
import type { JobReading } from "../../document/reading.ts";
import { useSettings } from "../../base/settings/settings.ts";
import { useTexts } from "../../base/settings/use-texts.ts";

/** Text instead of a picture for a DEF-active cycle. */
function ActingWords({ cycle }: { readonly cycle: number }) {
  const { name, description, notes } = useTexts().cycles.of[cycle as CycleNumber];
  return (
    <div className="help-slot acting-words small soft" role="group" aria-label={name} tabIndex={0}>
      {[...description, ...notes].map((sentence) => (
        <p key={sentence}>{sentence}</p>
      ))}
    </div>
  );
}

/** Help picture of this contour with the dimension of the open prompt highlighted. */
export function HelpSlot({
  read: typed,
  q,
  onPick,
}: {
  readonly read: JobReading;
  readonly q: string | null;
  readonly onPick: (q: string, taken: boolean) => void;
}) {
  // Deferred: after a keystroke the lathe view is drawn first, and after opening a prompt its field.
  const late = useDeferredUntilPaint(typed),
    lateQ = useDeferredUntilPaint(q);
  const [read, active] = late.cycle === typed.cycle ? [late, lateQ] : [typed, q];
  const language = useSettings((s) => s.language);
  const isBorrowed = read.cycle.contour === "free" && read.job.contour.length === 0;
  const given = useMemo(
    () => cycleGivens(isBorrowed ? { cycle: read.cycle, job: exampleJob(read.cycle) } : read),
    [isBorrowed, read],
  );
  const wrong = read.reading.issues.some((found) => found.code !== "missing");
  // A DEF-active cycle has no contour to draw.
  if (read.cycle.acts) return <ActingWords cycle={read.cycle.number} />;
  return (
    <div className="help-slot">
      <HelpPicture
        cycle={read.cycle}
        values={read.reading.values}
        partial={read.reading.partial as Numbers}
        wrong={wrong}
        given={given}
        isBorrowed={isBorrowed}
        activeQ={active}
        inches={read.inches ?? null}
        language={language}
        onPick={onPick}
      />
    </div>
  );
}
