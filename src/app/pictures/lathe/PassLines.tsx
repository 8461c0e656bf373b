import { memo, useEffect, useRef } from "react";
import { progressOf, type PathStretch } from "../../../view/passes.ts";
import type { Shape } from "../../../view/scene.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";

/**
 * Frames between two changes of the lines during playback. Each change repaints the whole drawing, so a long path
 * changes rarely.
 */
const PICTURES = { usual: 8, long: 60 } as const;

/** The lines of a stretch; unchanged ones are not rendered again. */
const StretchLines = memo(function StretchLines({ shapes }: { readonly shapes: readonly Shape[] }) {
  return (
    <g>
      {shapes.map(({ role, d }) => (
        <path key={role} className={`shape-${role}`} d={d} />
      ))}
    </g>
  );
});

/**
 * The path by its passes: coming ones faint, the running one strong, done ones faded. A class changes only where a pass
 * begins or ends, and at high speed not for each pass.
 */
export const PassLines = memo(function PassLines({
  stretches,
  playback,
  isLong,
}: {
  readonly stretches: readonly PathStretch[];
  readonly playback: PlaybackStore;
  readonly isLong: boolean;
}) {
  const group = useRef<SVGGElement>(null);
  useEffect(() => {
    const element = group.current;
    if (!element) return undefined;
    let shown = -1,
      waits = 0;
    const said = stretches.map(() => "");
    const paint = () => {
      const { playing } = playback.get(),
        { step } = playback.shown();
      waits -= 1;
      if (step === shown || (playing && waits > 0)) return;
      shown = step;
      let changed = false;
      stretches.forEach((stretch, i) => {
        const progress = progressOf(stretch, step);
        if (progress === said[i]) return;
        said[i] = progress;
        changed = true;
        const lines = element.children[i],
          name = `pass-${progress}`;
        if (lines?.getAttribute("class") !== name) lines?.setAttribute("class", name);
      });
      if (changed) waits = isLong ? PICTURES.long : PICTURES.usual;
    };
    paint();
    return playback.subscribe(paint);
  }, [stretches, playback, isLong]);
  return (
    <g ref={group} className={isLong ? "lathe-paths long" : "lathe-paths"}>
      {stretches.map(({ shapes }, i) => (
        <StretchLines key={i} shapes={shapes} />
      ))}
    </g>
  );
});
