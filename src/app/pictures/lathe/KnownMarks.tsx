import { useEffect, useMemo, useState } from "react";
import type { StoreApi } from "zustand";
import type { PartialWork } from "../../../program/job/partial-work.ts";
import type { Pt } from "../../../kernel/geometry/point.ts";
import type { Tool } from "../../../kernel/plan/tool.ts";
import type { Run } from "../../../program/state/run-types.ts";
import { axial, diameter, radius, toRadius } from "../../../kernel/units.ts";
import { toScreen } from "../../../view/camera.ts";
import type { LabelBox } from "../../../view/dimensions/labels.ts";
import { namedLines, toolArea, type NamedLine } from "../../../view/known-labels.ts";
import { tipAt } from "../../../view/tip.ts";
import { usePlace } from "../../place/place.ts";
import { useLengths } from "../../calculation/lengths.ts";
import type { InitialScene } from "../../calculation/moving.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { SCALE_BELOW, SCALE_LEFT } from "./Axes.tsx";
import { underTools } from "./PlaceButtons.tsx";
import { positionText, valueText } from "./known-text.ts";
import { useCamera } from "./use-camera.ts";
import { usePlayback } from "./use-playback.ts";
import type { Viewport } from "./viewport.ts";

/** A picture smaller than this shows only the numbers, pixels. */
const ROOM = { width: 480, height: 240 };
/** Height kept for notes at the upper edge, pixels. */
const NOTES = { large: 32, small: 6 };
/** From the top of a text's box to its baseline, pixels. */
const BASELINE = 12;
const NO_TOOL = { tool: null, tip: null };

/** What may move under the texts, and the areas that they take, for others. */
interface Around {
  readonly viewport: Viewport;
  readonly run: Run;
  readonly playback: PlaybackStore;
  /** The tool at its start, while nothing moves. */
  readonly waiting: InitialScene | null;
  readonly taken: StoreApi<readonly LabelBox[]>;
}

/** The tool where it rests: texts keep clear of it, and do not jump about while it moves. */
function useRestingTool({ run, playback, waiting }: Around): { readonly tool: Tool; readonly tip: Pt } | null {
  const rests = usePlayback(playback, (s) => {
    const { playing, position } = s.get();
    return playing ? null : position.step + position.fraction;
  });
  const [kept, keep] = useState(rests);
  if (rests !== null && rests !== kept) keep(rests);
  const now = rests ?? kept ?? 0,
    step = Math.floor(now);
  const tip = tipAt(run.steps, { step, fraction: now - step }),
    tool = run.steps[Math.min(step, run.steps.length - 1)]?.tool;
  if (tip && tool) return { tip, tool };
  return waiting?.tool && waiting.start ? { tip: waiting.start, tool: waiting.tool } : null;
}

/**
 * Line at the position of the open prompt, in a picture that has its path; at all positions while the values make no
 * contour.
 */
export function AskedMarks({ known, ...around }: Around & { readonly known: PartialWork }) {
  const asked = usePlace((p) => p.prompt),
    { outline, points } = known;
  const positions = outline.whole ? outline.positions.filter(({ q }) => q === asked) : outline.positions;
  if (positions.length === 0) return null;
  return (
    <KnownMarks
      {...around}
      known={{ ...known, outline: { ...outline, positions }, points: outline.whole ? [] : points }}
    />
  );
}

/** Lines at the positions typed so far, and the corners that they make. */
export function KnownMarks({
  known: {
    outline: { positions },
    points,
  },
  ...around
}: Around & { readonly known: PartialWork }) {
  const { viewport, taken } = around;
  const camera = useCamera(viewport),
    { width, height } = viewport.size();
  const lengths = useLengths();
  const resting = useRestingTool(around);
  const floor = height - SCALE_BELOW,
    right = width - underTools();
  const isSmall = width < ROOM.width || height < ROOM.height,
    text = isSmall ? valueText : positionText;
  const top = isSmall ? NOTES.small : NOTES.large;
  const lines = useMemo(
    () =>
      positions.map((p): NamedLine => {
        const { x, y } = toScreen(
          camera,
          p.axis === "x" ? { z: axial(0), r: toRadius(diameter(p.value)) } : { z: axial(p.value), r: radius(0) },
        );
        return { text: text(lengths, p), ...(p.axis === "x" ? { way: "level", at: y } : { way: "upright", at: x }) };
      }),
    [positions, camera, lengths, text],
  );
  const { tool, tip } = resting ?? NO_TOOL;
  const labels = useMemo(() => {
    const box = tool && tip && toolArea(tool, tip, camera);
    return namedLines(
      lines,
      { x: SCALE_LEFT, y: top, width: right - SCALE_LEFT, height: floor - top },
      box ? [box] : [],
    );
  }, [lines, tool, tip, camera, right, floor, top]);
  useEffect(() => {
    taken.setState(labels, true);
    return () => taken.setState([], true);
  }, [taken, labels]);
  return (
    <g className="lathe-known" aria-hidden="true">
      <path
        className="line"
        d={lines
          .map(({ way, at }) => (way === "level" ? `M${SCALE_LEFT} ${at}H${width}` : `M${at} 0V${floor}`))
          .join("")}
      />
      {lines.map((line, i) => {
        const box = labels[i];
        return (
          box && (
            <text key={positions[i]?.q} className="number" x={box.x} y={box.y + BASELINE}>
              {line.text}
            </text>
          )
        );
      })}
      {points.map((point, i) => {
        const at = toScreen(camera, point);
        return <circle key={i} cx={at.x} cy={at.y} r="4.5" />;
      })}
    </g>
  );
}
