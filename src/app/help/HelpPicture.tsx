import { useId, useMemo, useRef, useState } from "react";
import type { Cycle, Given, Outline } from "../../cycles/define.ts";
import { firstValues } from "../../cycles/first-values.ts";
import { pointPlan } from "../../cycles/point-plan.ts";
import type { Plan } from "../../kernel/plan.ts";
import { texts } from "../settings/loaded-texts.ts";
import type { Language } from "../../i18n/languages.ts";
import { formatNumber } from "../../i18n/number.ts";
import type { Numbers } from "../../view/help/lettering.ts";
import { helpDrawing } from "../../view/help/picture.ts";
import { Hatches, HelpMarks } from "./HelpMarks.tsx";
import { pictureInWords } from "./spoken.ts";
import { useSize } from "./use-size.ts";
import "./help.css";

interface Props {
  readonly cycle: Cycle;
  /** All values of the cycle; null while one is missing or no number. */
  readonly values: Numbers | null;
  /** Values that can be read so far: what the active prompt says. */
  readonly partial?: Numbers;
  readonly given: Given;
  readonly activeQ: string | null;
  readonly language: Language;
}

interface Drawn {
  readonly cycle: Cycle;
  readonly values: Numbers;
  readonly outline: Outline;
  readonly plan: Plan;
}

/** Height of the line that says what a dimmed drawing shows, pixels. */
const NOTE = 22;

/** A contour that can be drawn: it has elements, and nothing in it is impossible. */
const possible = (outline: Outline) => outline.contour.length > 0 && !outline.issues.some((found) => found.severity === "error");

/** What these values draw. */
function drawnBy(cycle: Cycle, values: Numbers, given: Given): Drawn {
  const read = values as Parameters<Cycle["outline"]>[0];
  const outline = cycle.outline(read, given);
  return { cycle, values, outline, plan: pointPlan(cycle, read, outline, given) };
}

/** The same; null while they draw nothing. */
function possiblyDrawnBy(cycle: Cycle, values: Numbers | null, given: Given): Drawn | null {
  const drawn = values && drawnBy(cycle, values, given);
  return drawn && possible(drawn.outline) ? drawn : null;
}

/**
 * A shop drawing of the contour that the values describe, the active prompt's dimension strong. Values that are missing
 * or impossible leave the last possible drawing, dimmed; before there was one, the printed example.
 */
export function HelpPicture({ cycle, values, partial, given, activeQ, language }: Props) {
  const box = useRef<HTMLDivElement>(null);
  const id = useId();
  const size = useSize(box, { width: 400, height: 280 });
  const now = useMemo(() => possiblyDrawnBy(cycle, values, given), [cycle, values, given]);
  const [last, setLast] = useState<Drawn | null>(now);
  if (now && now !== last) setLast(now);
  const kept = now ?? (last?.cycle === cycle ? last : null);
  const shown = useMemo(() => kept ?? drawnBy(cycle, firstValues(cycle), given), [kept, cycle, given]);
  const t = texts(language);
  const { width } = size;
  // The printed example leaves room for its note; the last drawing stays as it is, so that nothing jumps while one types.
  const height = kept ? size.height : Math.max(1, size.height - NOTE);
  const drawing = useMemo(() =>
    helpDrawing({
      params: cycle.params,
      values: shown.values,
      outline: shown.outline,
      plan: shown.plan,
      active: activeQ,
      size: { width, height },
      speech: {
        number: (n, decimals) => formatNumber(language, n, decimals),
        element: [t.help.element.none, t.help.element.chamfer, t.help.element.radius],
        reserved: t.help.reserved,
        notToScale: t.help.notToScale,
      },
    }), [cycle, shown, activeQ, width, height, language, t]);
  const said = partial ?? values ?? {};
  const note = now ? null : kept ? t.help.stale : t.help.example;
  return (
    <div className="help-picture" ref={box}>
      <svg role="img" viewBox={`0 0 ${size.width} ${size.height}`}
        aria-label={[pictureInWords(t, language, cycle, activeQ, said), note].filter((s) => s !== null).join(" ")}
        {...(now ? {} : { className: "dimmed" })}
      >
        <Hatches id={id} />
        <HelpMarks marks={drawing.marks} id={id} />
      </svg>
      {note && <p className="help-note" aria-hidden="true">{note}</p>}
    </div>
  );
}
