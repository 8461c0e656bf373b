import { useMemo } from "react";
import { compensate } from "../../../kernel/plane/compensate.ts";
import type { ApproachForm } from "../../../nc/words.ts";
import type { PlanePoint } from "../../../kernel/plane/plane.ts";
import type { WorkingPlane } from "../../../program/motion/approach-fields.ts";
import { approachDrawing } from "../../../view/approach/drawing.ts";
import { nearby, type SuggestedForm } from "../../../view/approach/forms.ts";
import type { PlaneSegment } from "../../../kernel/plane/plane.ts";
import { HelpMarks } from "../../../app/pictures/help/HelpMarks.tsx";
import { useLengths } from "../../../app/calculation/lengths.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { PointDots } from "../../../app/pictures/plane/PointDot.tsx";
import { approachSpeech } from "../../../app/pictures/plane/speech.ts";

const SIZE = { width: 132, height: 88 };
const NO_TIP: PlanePoint = { x: 0, y: 0 };
/** Farther elements of the contour are left out of a small picture, in tool radii. */
const NEAR = 40;

/** One form as a small picture with its name, to choose. */
export function FormCard({
  suggested,
  form,
  contour,
  plane,
  chosen,
  onTake,
}: {
  readonly suggested: SuggestedForm;
  /** Its word: "LT", or "PLT". */
  readonly form: ApproachForm;
  readonly contour: readonly PlaneSegment[];
  readonly plane: WorkingPlane;
  readonly chosen: boolean;
  readonly onTake: () => void;
}) {
  const t = useTexts().approach,
    lengths = useLengths();
  const { shape, departing, request, result } = suggested;
  const drawing = useMemo(() => {
    const near = nearby(contour, departing, Math.max(100, request.toolRadius * NEAR));
    const centre = compensate(near, request.side, request.toolRadius).pieces.map((p) => p.segment);
    return approachDrawing({
      result,
      contour: near,
      centre,
      toolRadius: request.toolRadius,
      rapidBefore: false,
      active: null,
      size: SIZE,
      small: true,
      speech: approachSpeech(lengths, plane, NO_TIP),
    });
  }, [contour, departing, request, result, lengths, plane]);
  const name = `${departing ? "DEP" : "APPR"} ${form}`;
  const words = t.shapes[shape];
  return (
    <li>
      <button
        type="button"
        className="form-card"
        aria-pressed={chosen}
        aria-label={t.take(name, words.name)}
        title={words.about}
        onClick={onTake}
      >
        <svg
          className="form-drawing help-picture approach-picture"
          aria-hidden="true"
          viewBox={`0 0 ${SIZE.width} ${SIZE.height}`}
        >
          <HelpMarks marks={drawing.marks} id={name.replace(" ", "")} />
          <PointDots points={drawing.points} />
        </svg>
        <b className="number">{name}</b>
        <span className="small soft">{words.name}</span>
      </button>
    </li>
  );
}
