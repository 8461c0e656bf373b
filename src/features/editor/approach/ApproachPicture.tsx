import { useId, useMemo, useRef, useState } from "react";
import { pointText } from "../../../view/approach/points.ts";
import { approach } from "../../../kernel/plane/approach.ts";
import { compensate } from "../../../kernel/plane/compensate.ts";
import { plane, type PlanePoint } from "../../../kernel/plane/plane.ts";
import type { ApproachForm } from "../../../nc/words.ts";
import type { ApproachWord } from "../../../program/motion/approach-fields.ts";
import type { ApproachContext, ReadyApproach } from "../../../program/edits/approach-request.ts";
import { dragged, handlesOf, type Dragged } from "../../../view/approach/drag.ts";
import { approachDrawing } from "../../../view/approach/drawing.ts";
import { nearby } from "../../../view/approach/forms.ts";
import { px } from "../../../view/help/marks.ts";
import { HelpMarks } from "../../../app/pictures/help/HelpMarks.tsx";
import { useSize } from "../../../app/pictures/help/use-size.ts";
import { useLengths } from "../../../app/calculation/lengths.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { PointDots } from "../../../app/pictures/plane/PointDot.tsx";
import { approachSpeech } from "../../../app/pictures/plane/speech.ts";
import { gridOf, useDrag } from "../../../app/pictures/plane/use-drag.ts";
import "../../../app/pictures/help/help.css";
import "../../../app/pictures/plane/approach.css";

const { scaled } = plane;

/** Farther elements of a long contour are left out of the picture, mm. */
const FARTHEST = 500;

/**
 * The drawing of one block: its points with their coordinates, tangent, dimensions and the path of the tool centre.
 * Points can be dragged.
 */
export function ApproachPicture({
  name,
  form,
  ready,
  context,
  active,
  onDrag,
}: {
  /** "APPR LT" */
  readonly name: string;
  readonly form: ApproachForm;
  /** Null keeps the last picture, dimmed. */
  readonly ready: ReadyApproach | null;
  readonly context: ApproachContext;
  readonly active: ApproachWord | null;
  readonly onDrag: (change: Dragged) => void;
}) {
  const t = useTexts().approach,
    lengths = useLengths(),
    id = useId();
  const box = useRef<HTMLDivElement>(null);
  const size = useSize(box, { width: 400, height: 280 });
  const [last, keep] = useState(ready);
  if (ready && ready !== last) keep(ready);
  const shown = ready ?? last;
  const made = useMemo(() => {
    if (!shown) return null;
    const { request } = shown;
    const contour = nearby(shown.contour, request.departing, FARTHEST);
    const path = compensate(contour, request.side, request.toolRadius).pieces.map((p) => p.segment);
    return { result: approach(request), contour, centre: path };
  }, [shown]);
  const speech = useMemo(
    () => approachSpeech(lengths, context.plane, context.tip),
    [lengths, context.plane, context.tip],
  );

  /** From the programmed point to its handle: PA is on the contour, PN on the path of the tool centre. */
  const offset: PlanePoint = shown?.request.departing ? scaled(context.tip, -1) : { x: 0, y: 0 };
  const drag = useDrag((handle, to, camera) => {
    const change = made && dragged(made.result, handle, to, gridOf(camera), offset);
    if (change) onDrag(change);
  });
  const drawing = useMemo(
    () =>
      made &&
      approachDrawing({
        ...made,
        toolRadius: context.toolRadius,
        rapidBefore: context.feedBefore === "rapid",
        active,
        size,
        small: false,
        speech,
        ...(drag.camera && { camera: drag.camera }),
      }),
    [made, context, active, size, speech, drag.camera],
  );

  if (!drawing || !made)
    return (
      <div className="approach-picture" ref={box}>
        <p className="approach-empty soft">{t.noPicture}</p>
      </div>
    );
  const spoken = drawing.points
    .filter(({ names }) => names.length > 0)
    .map((p) => t.point(p.names.join(" = "), pointText(p, speech)))
    .join(", ");
  const handles = handlesOf(made.result, form.startsWith("P") && !context.pole).flatMap((handle) => {
    const place =
      handle === "centre" ? drawing.centre?.place : drawing.points.find((p) => p.names.includes(handle))?.place;
    return place ? [{ handle, place }] : [];
  });
  return (
    <div className="help-picture approach-picture" ref={box}>
      <svg
        role="img"
        aria-label={`${t.picture(name, spoken)}${ready ? "" : ` ${t.stale}`}`}
        viewBox={`0 0 ${size.width} ${size.height}`}
        {...(ready ? {} : { className: "dimmed" })}
      >
        <HelpMarks marks={drawing.marks} id={id} />
        {handles.map(({ handle, place }) => (
          <g
            key={handle}
            className={`approach-handle${drag.handle === handle ? " held" : ""}`}
            data-handle={handle}
            onPointerDown={(event) => drag.begin(handle, drawing.camera, event)}
            onPointerMove={drag.move}
            onPointerUp={drag.end}
            onPointerCancel={drag.end}
          >
            <circle className="reach" cx={px(place.x)} cy={px(place.y)} r={18} />
            {handle === "centre" ? (
              <path className="grip" d={`M${px(place.x - 6)} ${px(place.y)}h12M${px(place.x)} ${px(place.y - 6)}v12`} />
            ) : (
              <circle className="grip" cx={px(place.x)} cy={px(place.y)} r={6} />
            )}
          </g>
        ))}
        <PointDots points={drawing.points} />
      </svg>
      {!ready && (
        <p className="help-note" aria-hidden="true">
          {t.stale}
        </p>
      )}
    </div>
  );
}
