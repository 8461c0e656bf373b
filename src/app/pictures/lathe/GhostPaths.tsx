import { useEffect, useRef, useState } from "react";
import { pathStretches, wholePath } from "../../../view/passes.ts";
import { PATH_ROLES, type Scene, type Shape } from "../../../view/scene.ts";
import type { Clock } from "../../base/clock.ts";
import { useCompared } from "../../findings/effect/compared.ts";
import { reducedMotion } from "../../base/settings/appearance.ts";
import { useSettings } from "../../base/settings/settings.ts";

/** How long the previous path stays visible after a change, ms. */
const STAYS = 2000;
/** Number of fade steps, and their interval, ms; each repaints the whole picture. */
const STEPS = 3,
  STEP = 250;

/** Longer paths have no ghost, because a change must be visible at once; characters of path data. */
const MOST = 400_000;

function pathOf({ shapes }: Pick<Scene, "shapes">): readonly Shape[] {
  const path = shapes.filter(({ role }) => PATH_ROLES.some((line) => line === role));
  return path.reduce((sum, { d }) => sum + d.length, 0) > MOST ? [] : path;
}
const sameShapes = (a: readonly Shape[], b: readonly Shape[]) =>
  a.length === b.length && a.every(({ d }, i) => d === b[i]?.d);

/** Schedules the next fade step; with a stopped clock, at its next frame. */
function scheduleFadeStep(clock: Clock, go: (now: number) => void): () => void {
  if (!clock.flows) return clock.frame(go);
  const timer = setTimeout(() => go(clock.now()), STEP);
  return () => clearTimeout(timer);
}

const Lines = ({ shapes, className }: { readonly shapes: readonly Shape[]; readonly className: string }) => (
  <g className={className}>
    {shapes.map(({ role, d }) => (
      <path key={role} className={`shape-ghost shape-ghost-${role}`} d={d} />
    ))}
  </g>
);

/**
 * The path before the last change. It stays for two seconds and then fades, or disappears at once with reduced motion.
 * A CSS fade would repaint the whole picture 60 times a second while the next key waits.
 */
function PreviousPath({ scene, clock }: { readonly scene: Scene; readonly clock: Clock }) {
  const motion = useSettings((s) => s.motion);
  const [last, keep] = useState(scene);
  const [former, show] = useState<readonly Shape[] | null>(null);
  const lines = useRef<SVGGElement>(null);
  if (scene !== last) {
    keep(scene);
    const [before, now] = [pathOf(last), pathOf(scene)];
    if (before.length > 0 && now.length > 0 && !sameShapes(before, now)) show(before);
  }
  useEffect(() => {
    if (!former) return undefined;
    const begun = clock.now(),
      still = reducedMotion({ motion });
    let stop = () => undefined as void;
    const fade = (now: number) => {
      const left = Math.ceil((begun + STAYS - now) / STEP);
      if (left <= 0) return show(null);
      if (lines.current) lines.current.style.opacity = still ? "" : String(Math.min(1, left / STEPS));
      stop = scheduleFadeStep(clock, fade);
    };
    fade(begun);
    return () => stop();
  }, [former, clock, motion]);
  return (
    former && (
      <g ref={lines}>
        <Lines shapes={former} className="lathe-former" />
      </g>
    )
  );
}

/** The path of the pinned reference. It is made like that of the picture, so that an equal path gives equal lines. */
function PinnedPath({ scene }: { readonly scene: Scene }) {
  const run = useCompared((c) => c.pinned?.outcome.run ?? null);
  const [drawn, draw] = useState<{ readonly of: typeof run; readonly shapes: readonly Shape[] }>({
    of: null,
    shapes: [],
  });
  if (run !== drawn.of) draw({ of: run, shapes: run ? pathOf({ shapes: wholePath(pathStretches(run.steps)) }) : [] });
  return drawn.shapes.length > 0 && !sameShapes(drawn.shapes, pathOf(scene)) ? (
    <Lines shapes={drawn.shapes} className="lathe-pinned" />
  ) : null;
}

/** Paths of other settings, under the tool: the previous and the pinned one. */
export function GhostPaths({ scene, clock }: { readonly scene: Scene; readonly clock: Clock }) {
  return (
    <>
      <PinnedPath scene={scene} />
      <PreviousPath scene={scene} clock={clock} />
    </>
  );
}
