import { useRef } from "react";
import type { Answer } from "../../../course/judge/judgement.ts";
import type { TruePlace } from "../../../course/judge/predicting.ts";
import { at, type Pt } from "../../../kernel/geometry/point.ts";
import { axial, radius } from "../../../kernel/units.ts";
import { boundsOf } from "../../../view/bounds.ts";
import { ringData, segmentData } from "../../../view/path.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";

/** Margin around the part, and size of a mark, as shares of its length. */
const AIR = 0.05,
  MARK = 0.012;

/**
 * The half section before the run, with the contours of its cycles: a click enters a place. `within`: tolerance, mm.
 */
export function QuestionPicture({
  begun: { run },
  truth,
  within,
  said,
  take,
}: {
  readonly begun: Answer;
  readonly truth: TruePlace | null;
  readonly within: number;
  readonly said: Pt | null;
  readonly take: (place: Pt) => void;
}) {
  const t = useTexts("course-teach");
  const svg = useRef<SVGSVGElement>(null);
  const box = boundsOf(run.blank.flat());
  if (!box) return null;
  const air = AIR * (box.right - box.left),
    mark = MARK * (box.right - box.left);
  const low = Math.min(0, box.low) - air;
  return (
    <svg
      ref={svg}
      className="teach-picture"
      role="img"
      aria-label={t.preview}
      viewBox={`${box.left - air} ${-(box.high + air)} ${box.right - box.left + 2 * air} ${box.high + air - low}`}
      onClick={(event) => {
        const inverse = svg.current?.getScreenCTM()?.inverse();
        if (!inverse) return;
        const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(inverse);
        take(at(axial(x), radius(-y)));
      }}
    >
      <g transform="scale(1 -1)">
        <path className="teach-blank" d={ringData(run.blank)} fillRule="evenodd" />
        {run.operations.map(({ plan }, i) => (
          <path key={i} className="teach-contour" d={segmentData(plan.contour)} />
        ))}
        <path className="teach-axis" d={`M${box.left - air} 0H${box.right + air}`} />
        {truth?.place && (
          <>
            <circle className="teach-within" cx={truth.place.z} cy={truth.place.r} r={within} />
            <path className="teach-truth" d={ringData(truth.rings)} fillRule="evenodd" />
          </>
        )}
        {said && (
          <path
            className="teach-said"
            d={`M${said.z - mark} ${said.r}h${2 * mark}M${said.z} ${said.r - mark}v${2 * mark}`}
          />
        )}
      </g>
    </svg>
  );
}
