import { useEffect, useRef, useState } from "react";
import { pathStretches, wholePath } from "../../view/passes.ts";
import { PATH_ROLES, type Scene, type Shape } from "../../view/scene.ts";
import type { Clock } from "../clock.ts";
import { useCompared } from "../effect/before.ts";
import { reducedMotion } from "../settings/appearance.ts";
import { useSettings } from "../settings/settings.ts";

/** How long the path stays to be seen that a change has replaced, ms. */
const STAYS = 2000;

/** Longer paths have no ghost: a change must be seen at once, characters of path data. */
const MOST = 400_000;

function pathOf({ shapes }: Pick<Scene, "shapes">): readonly Shape[] {
  const path = shapes.filter(({ role }) => PATH_ROLES.some((line) => line === role));
  return path.reduce((sum, { d }) => sum + d.length, 0) > MOST ? [] : path;
}
const sameShapes = (a: readonly Shape[], b: readonly Shape[]) => a.length === b.length && a.every(({ d }, i) => d === b[i]?.d);

const Lines = ({ shapes, className }: { readonly shapes: readonly Shape[]; readonly className: string }) => (
  <g className={className}>{shapes.map(({ role, d }) => <path key={role} className={`shape-ghost shape-ghost-${role}`} d={d} />)}</g>
);

/**
 * The path before the last change: it fades in two seconds, or without motion stays as long and goes at once. The browser fades it by
 * itself, so that the next key has the page for itself; only held time is followed picture by picture.
 */
function Former({ scene, clock }: { readonly scene: Scene; readonly clock: Clock }) {
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
    const gone = () => show(null), still = reducedMotion({ motion });
    if (clock.flows && lines.current?.animate) {
      const fading = lines.current.animate({ opacity: still ? [1, 1] : [1, 0] }, STAYS);
      fading.onfinish = gone;
      return () => fading.cancel();
    }
    const begun = clock.now();
    let stop: (() => void) | null = null;
    const picture = (now: number) => {
      const left = 1 - (now - begun) / STAYS;
      if (left <= 0) return gone();
      if (!still && lines.current) lines.current.style.opacity = String(left);
      stop = clock.frame(picture);
    };
    stop = clock.frame(picture);
    return () => stop?.();
  }, [former, clock, motion]);
  return former && (
    <g ref={lines}>
      <Lines shapes={former} className="lathe-former" />
    </g>
  );
}

/** The path of the pinned setting, for as long as it is pinned; made as that of the picture is, so that the same path is the same lines. */
function Pinned({ scene }: { readonly scene: Scene }) {
  const run = useCompared((c) => c.pinned?.outcome.run ?? null);
  const [drawn, draw] = useState<{ readonly of: typeof run; readonly shapes: readonly Shape[] }>({ of: null, shapes: [] });
  if (run !== drawn.of) draw({ of: run, shapes: run ? pathOf({ shapes: wholePath(pathStretches(run.steps)) }) : [] });
  return drawn.shapes.length > 0 && !sameShapes(drawn.shapes, pathOf(scene))
    ? <Lines shapes={drawn.shapes} className="lathe-pinned" />
    : null;
}

/** Paths of other settings, under the tool: the one before the last change, and the pinned one. */
export function GhostPaths({ scene, clock }: { readonly scene: Scene; readonly clock: Clock }) {
  return (
    <>
      <Pinned scene={scene} />
      <Former scene={scene} clock={clock} />
    </>
  );
}
