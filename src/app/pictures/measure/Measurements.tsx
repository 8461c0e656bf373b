import { measuredIn } from "../../document/edits.ts";
import type { Viewport } from "../lathe/viewport.ts";
import { lazyPart } from "../../base/parts.ts";
import { useEditor } from "../../document/store.ts";
import type { MeasuringShown } from "./measuring.ts";
import type { MeasureSource } from "./source.ts";

/** Loaded once something is or was measured. */
const MeasureLayer = lazyPart(async () => ({ default: (await import("./MeasureLayer.tsx")).MeasureLayer }));

/** Measurements over a picture, and the tools while measuring. Rendered inside the stage. */
export function Measurements(props: {
  readonly viewport: Viewport;
  readonly measuring: MeasuringShown;
  readonly source: MeasureSource;
}) {
  const { measuring, source } = props;
  const isMeasured = useEditor((s) => measuredIn(s).some(({ plane }) => plane === source.plane));
  if (!measuring.on && !isMeasured) return null;
  return <MeasureLayer {...props} />;
}

/** Loaded when the 3D view of a measured work is shown. */
const MeasuredElsewhere = lazyPart(async () => ({
  default: (await import("./MeasuredElsewhere.tsx")).MeasuredElsewhere,
}));

/** Measurements stay in the section; the 3D view says where to see them. */
export function MeasuredInSection() {
  const count = useEditor((s) => measuredIn(s).filter(({ plane }) => plane === "ZX").length);
  return count > 0 && <MeasuredElsewhere count={count} />;
}
