import { useEffect, useMemo, useRef } from "react";
import type { StoreApi } from "zustand";
import { part, type Pt, type Ring } from "../../../kernel/geometry/point.ts";
import { CHORD } from "../../../kernel/tolerance.ts";
import type { Run } from "../../../program/state/run-types.ts";
import { leastCovering, labelPlaces } from "../../../view/edge-label.ts";
import { boundsOf } from "../../../view/bounds.ts";
import { toScreen, type Camera, type Place } from "../../../view/camera.ts";
import { edgeMark, type VisibleArea } from "../../../view/edge-mark.ts";
import { textWidth, type LabelBox } from "../../../view/dimensions/labels.ts";
import { tipAt } from "../../../view/tip.ts";
import { useLengths } from "../../calculation/lengths.ts";
import { holds } from "../../base/use-media.ts";
import { SCALE_BELOW, SCALE_LEFT } from "./Axes.tsx";
import { badgeAreas, markArea, TOOLS, underTools } from "./PlaceButtons.tsx";
import type { PicturePlace } from "./places.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { placeText } from "./running.ts";
import { sectionProjection } from "./place-projection.ts";
import type { Viewport } from "./viewport.ts";

/** Distance of the mark from the edge, text size, line height, and padding of the background, pixels. */
const [INSET, TEXT, LINE, GROUND] = [14, 12, 15, 3];

/** Bounds of a blank in the picture, on both sides of the axis. */
function workBox(ring: Ring, { zero, scale }: Camera): LabelBox | null {
  const box = boundsOf(ring);
  if (!box) return null;
  const { left, right, high } = box;
  return {
    x: zero.x + left * scale,
    y: zero.y - high * scale,
    width: (right - left) * scale,
    height: 2 * high * scale,
  };
}

/**
 * Arrow at the edge of the picture to a tool outside it, with its position in two short lines on a free spot. `kept`:
 * areas taken by others.
 */
export function OffscreenTool({
  viewport,
  playback,
  run,
  places,
  datum,
  kept,
}: {
  readonly viewport: Viewport;
  readonly playback: PlaybackStore;
  readonly run: Run;
  readonly places: readonly PicturePlace[];
  readonly datum: Pt;
  readonly kept: readonly StoreApi<readonly LabelBox[]>[];
}) {
  const group = useRef<SVGGElement>(null);
  const lengths = useLengths();
  const lines = useMemo(
    () => [
      ...run.blank.map((ring) => [...ring, ...ring.slice(0, 1)]),
      ...run.operations.map((o) => part.flattenedChain(o.plan.contour, 10 * CHORD)),
    ],
    [run],
  );
  useEffect(() => {
    const element = group.current,
      arrow = element?.querySelector("path"),
      text = element?.querySelector("text");
    const ground = element?.querySelector("rect"),
      [first, second] = element?.querySelectorAll("tspan") ?? [];
    if (!element || !arrow || !text || !ground || !first || !second) return undefined;
    const { steps, operations } = run;
    let room: VisibleArea = { left: 0, right: 0, top: 0, bottom: 0 },
      corner: LabelBox | null = null;
    let boxes: readonly LabelBox[] = [],
      areas: readonly LabelBox[] = [];
    let isShown = false,
      row = 0;
    /** The mark of a place, clear of what covers the corner of the picture. */
    const markOf = (at: Place) => {
      const mark = edgeMark(at, room);
      if (!mark || !corner || mark.at.x < corner.x - INSET || mark.at.y > corner.height + INSET) return mark;
      return edgeMark(at, { ...room, top: corner.height + INSET });
    };
    const paint = () => {
      const position = playback.shown(),
        tip = tipAt(steps, position),
        camera = viewport.get(),
        mark = tip && markOf(toScreen(camera, tip));
      if (isShown !== (mark !== null)) element.style.display = mark ? "" : "none";
      isShown = mark !== null;
      if (!mark || !tip) return;
      const {
          at: { x, y },
          turn,
        } = mark,
        { x: diameter, z } = placeText(lengths, tip),
        step = steps[position.step];
      const told = [`X⌀ ${diameter}`, `Z ${z}`] as const,
        wide = Math.max(...told.map((each) => textWidth(each, TEXT))) + 2 * GROUND;
      const choices = labelPlaces(mark.at, { width: wide, height: 2 * LINE + GROUND }, room, corner);
      row = leastCovering(
        choices,
        { boxes, areas, lines: step ? [...lines, [step.from, step.move.to]] : lines },
        { camera, size: viewport.size() },
        row,
      );
      const box = choices[row];
      if (!box) return;
      const toLeft = box.x < x;
      arrow.setAttribute("transform", `translate(${x} ${y}) rotate(${turn})`);
      for (const name of ["x", "y", "width", "height"] as const) ground.setAttribute(name, String(box[name]));
      for (const line of [first, second])
        line.setAttribute("x", String(toLeft ? box.x + wide - GROUND : box.x + GROUND));
      text.setAttribute("y", String(box.y + TEXT + 1));
      text.setAttribute("text-anchor", toLeft ? "end" : "start");
      told.forEach((each, i) => {
        const line = i === 0 ? first : second;
        if (line.textContent !== each) line.textContent = each;
      });
    };
    const look = () => {
      const { width, height } = viewport.size(),
        camera = viewport.get(),
        isPhone = holds("phone");
      room = {
        left: SCALE_LEFT + INSET,
        right: width - INSET - underTools(),
        top: INSET,
        bottom: height - SCALE_BELOW - INSET,
      };
      corner = isPhone ? { x: width - TOOLS, y: 0, width: TOOLS, height: TOOLS } : null;
      boxes = [
        ...badgeAreas(places, sectionProjection(viewport)),
        ...kept.flatMap((each) => each.getState()),
        markArea(toScreen(camera, datum)),
      ];
      areas = [
        ...run.blank.flatMap((ring) => workBox(ring, camera) ?? []),
        ...operations.map(({ start }) => markArea(toScreen(camera, start))),
      ];
      paint();
    };
    look();
    const ends = [
      viewport.subscribe(look),
      playback.subscribeReader(paint),
      ...kept.map((each) => each.subscribe(look)),
    ];
    return () => {
      ends.forEach((end) => end());
      element.style.display = "none";
    };
  }, [run, places, datum, kept, lines, viewport, playback, lengths]);
  return (
    <g ref={group} className="tool-away" aria-hidden="true" style={{ display: "none" }}>
      <rect rx="3" />
      <path d="M8 0L-6 6V-6Z" />
      <text className="number">
        <tspan />
        <tspan dy={LINE} />
      </text>
    </g>
  );
}
