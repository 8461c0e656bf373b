import { useMemo } from "react";
import { wayOf } from "../../../kernel/plane/mill-motion.ts";
import { partSegment } from "../../../kernel/plane/plane.ts";
import type { Run } from "../../../program/state/run-types.ts";
import { segmentData } from "../../../view/path.ts";
import { useMilledMarks } from "../selection.ts";

/** The milled motions of the choice, over the path. */
export function ChosenMotions({ run }: { readonly run: Run }) {
  const stretches = useMilledMarks(run);
  const d = useMemo(
    () =>
      stretches
        .map(({ first, last }) => segmentData(run.plane.slice(first, last + 1).map((m) => partSegment(wayOf(m)))))
        .join(""),
    [stretches, run],
  );
  return d && <path className="shape-marked" d={d} />;
}
