import { useId, useMemo, useRef, useState } from "react";
import { likelyCompletion } from "../../../cycles/completions.ts";
import type { Cycle, Given, Outline } from "../../../cycles/define.ts";
import { pointPlan } from "../../../cycles/point-plan.ts";
import type { Plan } from "../../../kernel/plan/plan.ts";
import type { DraftInches } from "../../../program/job/read-draft.ts";
import { texts } from "../../base/settings/loaded-texts.ts";
import type { Language } from "../../../i18n/languages.ts";
import { coarseContour } from "../../../view/help/coarse.ts";
import type { Numbers } from "../../../view/help/lettering.ts";
import { helpDrawing } from "../../../view/help/picture.ts";
import { Hatches, HelpMarks } from "./HelpMarks.tsx";
import { numberIn } from "./number-in.ts";
import { pictureInWords } from "./spoken.ts";
import { dimensionAt, usePressing } from "./press-dimension.ts";
import { useSize } from "./use-size.ts";
import "./help.css";

interface Props {
  readonly cycle: Cycle;
  /** All values of the cycle; null if one is missing or no number. */
  readonly values: Numbers | null;
  /** Values that can be read. */
  readonly partial?: Numbers;
  /** A prompt has an invalid value; until it is valid the last drawing stays. */
  readonly wrong?: boolean;
  readonly given: Given;
  /** The contour is an example; the operator has none yet. */
  readonly isBorrowed?: boolean;
  readonly activeQ: string | null;
  readonly language: Language;
  /** Lengths are written in inches, feeds per revolution or per minute; null: in mm. */
  readonly inches?: DraftInches | null;
  /** A dimension was clicked. `q`: the parameter that it shows. `taken`: put its value into the open prompt. */
  readonly onPick?: (q: string, taken: boolean) => void;
}

interface Drawn {
  readonly cycle: Cycle;
  readonly typed: Numbers;
  readonly values: Numbers;
  readonly isBorrowed: boolean;
  readonly outline: Outline;
  readonly plan: Plan;
}

/** The drawing of these values, with fallbacks for missing ones; null if they make no contour. */
function drawnBy(
  { cycle, given, isBorrowed }: Required<Pick<Props, "cycle" | "given" | "isBorrowed">>,
  typed: Numbers,
  before: Numbers | null,
): Drawn | null {
  const made = likelyCompletion(cycle, typed, given, before);
  if (!made) return null;
  const { values, outline } = made;
  return {
    cycle,
    typed,
    values: values as Numbers,
    isBorrowed,
    outline,
    plan: pointPlan(cycle, values, outline, given),
  };
}

const NOTHING: Numbers = {};

interface SheetProps extends Pick<Props, "cycle" | "activeQ" | "language" | "inches"> {
  readonly id: string;
  readonly shown: Drawn;
  readonly width: number;
  readonly height: number;
}

/** The drawing of the planned contour, separate so that a slow device can do other work in between. */
function HelpSheet({ id, cycle, shown, activeQ, language, inches = null, width, height }: SheetProps) {
  const t = texts(language);
  const drawing = useMemo(
    () =>
      helpDrawing({
        params: cycle.params,
        values: shown.values,
        typed: shown.typed,
        isBorrowed: shown.isBorrowed,
        outline: shown.outline,
        plan: shown.plan,
        active: activeQ,
        size: { width, height },
        speech: {
          number: numberIn(language, inches),
          element: [t.help.element.none, t.help.element.chamfer, t.help.element.radius],
          reserved: t.help.reserved,
          notToScale: t.help.notToScale,
        },
      }),
    [cycle, shown, activeQ, width, height, language, inches, t],
  );
  return <HelpMarks marks={drawing.marks} id={id} />;
}

/**
 * A shop drawing of the contour with the dimension of the active prompt highlighted. A missing value shows its Q number
 * instead of a measure. Invalid values leave the last valid drawing, dimmed.
 */
export function HelpPicture(props: Props) {
  const {
    cycle,
    values,
    partial,
    wrong = false,
    given: exact,
    isBorrowed = false,
    activeQ,
    language,
    inches = null,
    onPick,
  } = props;
  const contour = useMemo(() => coarseContour(exact.contour), [exact.contour]);
  const given = useMemo(() => ({ ...exact, contour }), [exact, contour]);
  const box = useRef<HTMLDivElement>(null);
  const id = useId();
  const size = useSize(box, { width: 400, height: 280 });
  const said = values ?? partial ?? NOTHING;
  const [whole, setWhole] = useState<{ readonly cycle: Cycle; readonly values: Numbers } | null>(null);
  const [last, setLast] = useState<Drawn | null>(null);
  // If all values are there, no previous ones are needed.
  const before = !values && whole?.cycle === cycle ? whole.values : null;
  const kept = last?.cycle === cycle ? last : null;
  const now = useMemo(
    () => (wrong ? null : drawnBy({ cycle, given, isBorrowed }, said, before)),
    [wrong, cycle, said, before, given, isBorrowed],
  );
  if (now && now !== last) setLast(now);
  if (now && values && whole?.values !== values) setWhole({ cycle, values });
  // Without a valid drawing so far, draw what the values allow, or the example of the cycle.
  const isFirst = !now && !kept;
  const first = useMemo(() => {
    const of = { cycle, given, isBorrowed };
    return isFirst ? (drawnBy(of, said, null) ?? drawnBy(of, NOTHING, null)) : null;
  }, [isFirst, cycle, said, given, isBorrowed]);
  const shown = now ?? kept ?? first;
  const isStale = !now && kept !== null;
  const t = texts(language);
  const note = isStale ? t.help.stale : values === null || isBorrowed ? t.help.partial : null;
  const pressing = usePressing((at, taken) => {
    const q = dimensionAt(at);
    if (q !== null) onPick?.(q, taken);
  });
  return (
    <div className="help-picture" ref={box}>
      <svg
        role="img"
        viewBox={`0 0 ${size.width} ${size.height}`}
        aria-label={[pictureInWords(t, language, cycle, activeQ, said, inches), note]
          .filter((s) => s !== null)
          .join(" ")}
        {...(isStale ? { className: "dimmed" } : {})}
        {...(onPick && pressing)}
      >
        <Hatches id={id} />
        {shown && (
          <HelpSheet
            id={id}
            cycle={cycle}
            shown={shown}
            activeQ={activeQ}
            language={language}
            inches={inches}
            {...size}
          />
        )}
      </svg>
      {isStale && (
        <p className="help-note" aria-hidden="true">
          {t.help.stale}
        </p>
      )}
    </div>
  );
}
