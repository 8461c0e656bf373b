import { useMemo } from "react";
import { threadProfile } from "../../../view/thread-profile.ts";
import { useOutcome } from "../../calculation/outcome.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { pageLength } from "../../base/unit.ts";
import { useThreadOperation } from "./thread-operation.ts";

/** Drawing area, pixels. */
const SIZE = { width: 150, height: 62 } as const;
/** Hues of the first and of the last pass, degrees. */
const HUES = { first: 205, last: 25 } as const;

/** Thread profile of the cycle in this program line, or of the job without a line, with each chip in its colour. */
export function ThreadPicture({ line }: { readonly line: number | null }) {
  const t = useTexts("threads");
  const dimmed = useOutcome((s) => s.dimmed);
  const thread = useThreadOperation(line)?.plan.thread;
  const drawing = useMemo(() => (thread ? threadProfile(thread, SIZE.width, SIZE.height) : null), [thread]);
  const place = { width: pageLength(SIZE.width), height: pageLength(SIZE.height) };
  // Its place is kept free until the first result: the prompts below stay put.
  if (!thread || !drawing) return <span className="thread-picture" style={place} />;
  const last = Math.max(1, drawing.chips.length - 1);
  const hue = (i: number) => HUES.first + ((HUES.last - HUES.first) * i) / last;
  return (
    <svg
      className={`thread-picture${dimmed ? " dimmed" : ""}`}
      role="img"
      aria-label={t.profile(thread.depths.length)}
      viewBox={`0 0 ${SIZE.width} ${SIZE.height}`}
      {...place}
    >
      <path className="thread-material" d={`M0 ${drawing.crest}H${SIZE.width}V${SIZE.height}H0Z`} />
      {drawing.chips.map(({ pass, points }, i) => (
        <path
          key={pass}
          className="thread-chip"
          fill={`hsl(${Math.round(hue(i))} 75% 55%)`}
          d={`M${points.map((p) => `${p.x.toFixed(2)} ${p.y.toFixed(2)}`).join("L")}Z`}
        />
      ))}
    </svg>
  );
}
