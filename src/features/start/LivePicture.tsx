import { useEffect, useId, useRef, useState } from "react";
import { clock } from "../../app/base/clock.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { reducedMotion } from "../../app/base/settings/appearance.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { durationOf, livePlace } from "./live-place.ts";
import type { LiveRun } from "./pictures.ts";

/** Least time between two frames, ms: other things run as well. */
const PICTURE = 30;
/** Where the paused picture stands: in the middle of roughing, as a share of the run. */
const STILL = 0.34;

/** Shows a run at a time by changing the DOM directly, without React. */
function showRunAt(svg: SVGSVGElement, run: LiveRun, time: number): number {
  const { z, r, inwards, before, after, pass } = livePlace(run, time);
  const [left, top, width, height] = run.box;
  const within = <E extends SVGElement>(name: string) => svg.querySelectorAll<E>(`[data-live="${name}"]`);
  const from = inwards ? left : z;
  for (const rect of within("left")) {
    rect.setAttribute("x", String(from));
    rect.setAttribute("width", String(Math.max(0, (inwards ? z : left + width) - from)));
    rect.setAttribute("y", String(top));
    rect.setAttribute("height", String(height));
  }
  for (const path of within("before")) path.setAttribute("d", run.stocks[before] ?? "");
  for (const path of within("after")) path.setAttribute("d", run.stocks[after] ?? "");
  for (const tool of within("tool")) tool.setAttribute("transform", `translate(${z.toFixed(3)} ${(-r).toFixed(3)})`);
  return pass;
}

/**
 * A real program on the lathe: the tool moves and removes material. It can be paused, and stands still with reduced
 * motion.
 */
export function LivePicture({ run }: { readonly run: LiveRun | undefined }) {
  const {
    page: {
      start: { live: t },
      effect,
    },
  } = useTexts("first");
  const language = useSettings((s) => s.language);
  const still = useSettings(reducedMotion);
  const [chosen, choose] = useState<boolean | null>(null);
  const [pass, say] = useState(0);
  const svg = useRef<SVGSVGElement>(null);
  const time = useRef<number | null>(null);
  const id = useId();
  const plays = run !== undefined && (chosen ?? !still);

  useEffect(() => {
    if (!run || !svg.current) return undefined;
    const whole = durationOf(run);
    time.current ??= still ? whole * STILL : 0;
    const show = (now: number) => {
      if (svg.current) say(showRunAt(svg.current, run, now));
    };
    show(time.current);
    if (!plays) return undefined;
    let before = clock.now();
    let cancel = () => undefined as void;
    const next = (now: number) => {
      if (now - before >= PICTURE) {
        // Out of view no frames are requested; the run resumes where it was.
        time.current = ((time.current ?? 0) + Math.min(now - before, 4 * PICTURE)) % whole;
        before = now;
        show(time.current);
      }
      cancel = clock.frame(next);
    };
    cancel = clock.frame(next);
    return () => cancel();
  }, [run, plays, still]);

  const number = new Intl.NumberFormat(language, { maximumFractionDigits: 3 });
  const doing = pass > 0 ? t.pass(pass, run?.passes ?? 0) : t[pass < 0 ? "finish" : "position"];
  const seconds = String((run?.seconds ?? 0) % 60).padStart(2, "0");
  return (
    <figure className="live-picture">
      <svg
        ref={svg}
        viewBox={(run?.box ?? [-119, -51, 127, 102]).join(" ")}
        role="img"
        aria-label={run ? t.name(run.cycle) : undefined}
        aria-hidden={run ? undefined : true}
      >
        {run && (
          <>
            <pattern id={`${id}hatch`} width="3" height="3" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
              <rect className="live-ground" width="3" height="3" />
              <path className="live-hatch" d="M0 0V3" />
            </pattern>
            <linearGradient id={`${id}steel`} gradientUnits="userSpaceOnUse" x1="0" y1="0" x2="0" y2={run.box[1]}>
              <stop className="live-steel" offset="0" />
              <stop className="live-light" offset="0.3" />
              <stop className="live-shade" offset="0.95" />
            </linearGradient>
            <clipPath id={`${id}left`}>
              <rect data-live="left" />
            </clipPath>
            {[1, -1].map((side) => (
              <g key={side} transform={`scale(1 ${side})`}>
                <path className="live-held" d={run.held} />
                <g className="live-stock" fill={`url(#${id}${side > 0 ? "hatch" : "steel"})`}>
                  <path data-live="after" />
                  <path data-live="before" clipPath={`url(#${id}left)`} />
                </g>
              </g>
            ))}
            <path className="live-feed" d={run.feeds} />
            <path className="live-rapid" d={run.rapids} />
            <path className="part-axis" d={`M${run.box[0]} 0H${run.box[0] + run.box[2]}`} />
            <path className="live-insert" data-live="tool" d={run.insert} />
          </>
        )}
      </svg>
      <figcaption>
        {run && (
          <>
            <button
              type="button"
              className="button icon plain"
              aria-label={plays ? t.pause : t.play}
              title={plays ? t.pause : t.play}
              onClick={() => choose(!plays)}
            >
              <Icon name={plays ? "pause" : "play"} />
            </button>
            <span className="live-doing">
              <b className="number card-number">{run.cycle}</b> {doing}
            </span>
            <span className="live-facts small soft number">
              {effect.passes} {run.passes} · {number.format(run.infeed)} {effect.infeedUnit} ·{" "}
              {effect.duration(Math.floor(run.seconds / 60), seconds)}
              {run.proved && ` · ${t.proved}`}
              {run.proved && (
                <span className="live-proved">
                  <Icon name="check" />
                </span>
              )}
            </span>
          </>
        )}
      </figcaption>
    </figure>
  );
}
