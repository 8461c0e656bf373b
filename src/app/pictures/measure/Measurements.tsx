import { Suspense } from "react";
import { measuredIn } from "../../document/edits.ts";
import type { Viewport } from "../lathe/viewport.ts";
import { lazyPart } from "../../base/parts.ts";
import { useEditor } from "../../document/store.ts";
import type { MeasuringShown } from "./measuring.ts";
import type { MeasureSource } from "./source.ts";

/** Fetched when something is measured, or was. */
const MeasureLayer = lazyPart(async () => ({ default: (await import("./MeasureLayer.tsx")).MeasureLayer }));

/** What was measured in a picture, over it, and the tools while it measures. Stands inside of the stage. */
export function Measurements(props: {
  readonly viewport: Viewport;
  readonly measuring: MeasuringShown;
  readonly source: MeasureSource;
}) {
  const { measuring, source } = props;
  const isMeasured = useEditor((s) => measuredIn(s).some(({ plane }) => plane === source.plane));
  if (!measuring.on && !isMeasured) return null;
  return (
    <Suspense>
      <MeasureLayer {...props} />
    </Suspense>
  );
}

/** Fetched when a body is looked at of which something was measured. */
const MeasuredElsewhere = lazyPart(async () => ({
  default: (await import("./MeasuredElsewhere.tsx")).MeasuredElsewhere,
}));

/** What was measured in the section stays; over the body in space it is said where it is to be seen. */
export function MeasuredInSection() {
  const count = useEditor((s) => measuredIn(s).filter(({ plane }) => plane === "ZX").length);
  return (
    count > 0 && (
      <Suspense>
        <MeasuredElsewhere count={count} />
      </Suspense>
    )
  );
}
