import { memo, useMemo } from "react";
import { wayOf } from "../../../kernel/plane/mill-motion.ts";
import { partSegment } from "../../../kernel/plane/plane.ts";
import type { Run } from "../../../program/state/run-types.ts";
import type { PlaneRole } from "../../../view/approach/plane-scene.ts";
import { segmentData } from "../../../view/path.ts";
import { planeOfRun } from "../../calculation/plane-run.ts";
import { useNewerRun } from "../lathe/NewestLines.tsx";
import { useMilledMarks } from "../selection.ts";

/** Lines over milled stock have a light edge, to be visible on its darkest tone. */
const EDGED: readonly PlaneRole[] = ["rapid", "feed", "lead"];

/** Contours and path, from a newer run if there is one, drawn with the key that changes them. */
export const PlaneLines = memo(function PlaneLines({ of }: { readonly of: Run }) {
  const {
    scene: { shapes },
  } = planeOfRun(useNewerRun(of) ?? of);
  return (
    <>
      <path className="plane-under" d={shapes.flatMap(({ role, d }) => (EDGED.includes(role) ? [d] : [])).join("")} />
      {shapes.map(({ role, d }) => (
        <path key={role} className={`plane-${role}`} d={d} />
      ))}
    </>
  );
});

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
