import {
  useEffect,
  useEffectEvent,
  useId,
  useLayoutEffect,
  useMemo,
  useRef,
  useState,
  type KeyboardEvent,
  type ReactNode,
} from "react";
import type { Pt, Segment } from "../../kernel/geometry/point.ts";
import type { ContourChoice, DrawnContour, Drawing } from "../../program/drawing/drawing.ts";
import { useSize } from "../../app/pictures/help/use-size.ts";
import { fitCanvas } from "../../app/pictures/lathe/fit-canvas.ts";
import { listenToGestures } from "../../app/pictures/lathe/gestures.ts";
import { GlyphButton } from "../../app/pictures/lathe/GlyphButton.tsx";
import { ZoomKeys } from "../../app/pictures/lathe/ViewBar.tsx";
import { pageLength, usePageUnit } from "../../app/base/unit.ts";
import { pageColours, useTheme } from "../../app/base/use-theme-colours.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import {
  fitted,
  panned,
  sheetShift,
  toPlace,
  zoomed,
  type Bounds,
  type Camera,
  type Place,
} from "../../view/camera.ts";
import { SHEET_MARGIN } from "./extent.ts";
import { acrossAxis, alongAxis } from "../../program/drawing/on-drawing.ts";
import { DRAWING_COLOURS, drawingPaths, paintDrawing, pathOf } from "./paint-drawing.ts";
import type { ArrowKey, PickKind } from "../../program/drawing/pick.ts";
import { axisPositions, nearestCurve, snapped, zeroPositions } from "../../program/drawing/positions.ts";
import { SheetOverlay, type SheetMarks } from "./SheetOverlay.tsx";

interface Props extends SheetMarks {
  readonly drawing: Drawing;
  readonly contour: DrawnContour;
  readonly pick: PickKind;
  /** A camera chosen by hand, or a box that fills the picture. */
  readonly view: Camera | Bounds;
  readonly whole: Bounds;
  /** The box of the contour; null without one. */
  readonly part: (() => Bounds) | null;
  readonly onView: (view: Camera | Bounds) => void;
  /** Controls in front of the zoom buttons. */
  readonly lead: ReactNode;
  /** A tap at a point of the drawing. `within`: its reach, mm. */
  readonly onTap: (at: Pt, within: number) => void;
  readonly onArrow: (key: ArrowKey) => void;
  /** A choice by dragging. */
  readonly onChange: (change: Partial<ContourChoice>) => void;
  /** The pointer is over a point of the drawing; null: over none. */
  readonly onHover: (at: Pt | null, within: number) => void;
}

/** Reach of a tap, units of the page. */
const REACH = { mouse: 12, touch: 24 } as const;
/** From this many curves on, and after this rest of the view, ms. */
const MANY = 3000,
  RESTS = 120;
/** Zoom and pan of one key. */
const ZOOM = 1.4,
  PAN = 40;
const PANS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [PAN, 0],
  ArrowRight: [-PAN, 0],
  ArrowUp: [0, PAN],
  ArrowDown: [0, -PAN],
};
const isArrow = (key: string): key is ArrowKey => Object.hasOwn(PANS, key);

/** The whole drawing, on which axis, zero point and contour are picked: by pointer, finger or arrow keys. */
export function DrawingSheet({
  drawing,
  contour,
  pick,
  view,
  whole,
  part: partBox,
  onView,
  lead,
  onTap,
  onArrow,
  onChange,
  onHover,
  ...marks
}: Props) {
  const { choice } = marks;
  const t = useTexts("drawing-import"),
    keysId = useId();
  const box = useRef<HTMLDivElement>(null),
    canvas = useRef<HTMLCanvasElement>(null);
  const size = useSize(box, { width: 640, height: 400 });
  const unit = usePageUnit(),
    theme = useTheme();
  const camera = "scale" in view ? view : fitted(view, size, SHEET_MARGIN, true);
  const [hovered, hover] = useState<Segment | null>(null);
  const paths = useMemo(() => drawingPaths(drawing), [drawing]);
  const curves = contour.pieces[choice.piece]?.curves;
  const piece = useMemo(
    () => pathOf((curves ?? []).flatMap((i) => drawing.curves[i]?.segment ?? [])),
    [drawing, curves],
  );

  /** The camera of the painted curves. */
  const painted = useRef<{ readonly camera: Camera; readonly piece: Path2D } | null>(null);
  useLayoutEffect(() => {
    const node = canvas.current,
      context = node?.getContext("2d");
    if (!node || !context) return undefined;
    const paint = () => {
      const ratio = (globalThis.devicePixelRatio || 1) * unit;
      fitCanvas(node, { x: 0, y: 0, ...size }, ratio);
      paintDrawing(context, { drawing, paths, piece, camera, size, ratio, colours: pageColours(DRAWING_COLOURS) });
      node.style.transform = "";
      painted.current = { camera, piece };
    };
    const before = painted.current;
    if (drawing.curves.length < MANY || before?.piece !== piece || before.camera === camera) return void paint();
    // Many curves are only shifted and scaled while the view moves, and painted again at rest.
    const { x, y, grown } = sheetShift(before.camera, camera);
    node.style.transform = `translate(${pageLength(x)}, ${pageLength(y)}) scale(${grown})`;
    const timer = setTimeout(paint, RESTS);
    return () => clearTimeout(timer);
  }, [drawing, paths, piece, camera, size, unit, theme]);

  const zoom = (factor: number, at: Place = { x: size.width / 2, y: size.height / 2 }) =>
    onView(zoomed(camera, factor, at));
  const reach = (byFinger = false) => REACH[byFinger ? "touch" : "mouse"] / camera.scale;
  /** What a drag from a place moves. */
  const grabbed = (from: Place, byFinger: boolean): "axis" | "zero" | null => {
    const p = toPlace(camera, from),
      near = reach(byFinger);
    const along = Math.abs(alongAxis(choice, p) - choice.zero),
      across = Math.abs(acrossAxis(choice, p) - choice.axisAt);
    if (along <= near && across <= near) return pick === "axis" ? "axis" : "zero";
    if (pick === "axis") return across <= near ? "axis" : null;
    return pick === "zero" && along <= near ? "zero" : null;
  };
  /** What the present drag moves: at its start it was under the pointer. */
  const dragging = useRef<"axis" | "zero" | null>(null);
  const begin = useEffectEvent((from: Place, byFinger: boolean) => {
    dragging.current = grabbed(from, byFinger);
    return dragging.current !== null;
  });
  const dragged = useEffectEvent((to: Place, byFinger: boolean) => {
    const p = toPlace(camera, to),
      near = reach(byFinger) / 2;
    if (dragging.current === "axis")
      onChange({ axisAt: snapped(axisPositions(drawing, choice.axis), acrossAxis(choice, p), near), piece: 0 });
    else if (dragging.current === "zero")
      onChange({ zero: snapped(zeroPositions(drawing, choice, contour), alongAxis(choice, p), near) });
  });
  const hovering = useEffectEvent((at: Place | null) => {
    const p = at && toPlace(camera, at);
    const index = p && pick !== "zero" ? nearestCurve(drawing.curves, p, reach()) : null;
    hover(index === null ? null : (drawing.curves[index]?.segment ?? null));
    onHover(p, reach());
  });
  const seen = useEffectEvent(() => camera);
  const look = useEffectEvent(onView),
    turned = useEffectEvent(zoom),
    tapped = useEffectEvent((at: Place, byFinger: boolean) => onTap(toPlace(camera, at), reach(byFinger)));
  useEffect(() => {
    const node = box.current;
    if (!node) return undefined;
    let byFinger = false;
    const press = (event: PointerEvent) => void (byFinger = event.pointerType === "touch");
    node.addEventListener("pointerdown", press);
    const stop = listenToGestures(
      node,
      { get: () => seen(), look: (next) => look(next), zoom: (factor, at) => turned(factor, at) },
      {
        tap: (at) => tapped(at, byFinger),
        hover: (at) => hovering(at),
        grabs: (from, finger) => begin(from, finger),
        drag: (_, to, __, finger = false) => dragged(to, finger),
      },
    );
    return () => {
      node.removeEventListener("pointerdown", press);
      stop();
    };
  }, []);

  // Where another drawing has replaced the focused one, the keyboard goes on here.
  useEffect(() => {
    const { activeElement, body } = document;
    if (activeElement === body || activeElement?.closest(".modal-head")) box.current?.focus();
  }, []);

  const onKeyDown = (e: KeyboardEvent<HTMLDivElement>) => {
    if (e.ctrlKey || e.metaKey || e.altKey) return;
    const { key } = e;
    const pan = PANS[key];
    if (pan && e.shiftKey) onView(panned(camera, pan[0], pan[1]));
    else if (isArrow(key)) onArrow(key);
    else if (key === "+" || key === "=") zoom(ZOOM);
    else if (key === "-") zoom(1 / ZOOM);
    else if (key === "0") onView(whole);
    else return;
    e.preventDefault();
  };

  return (
    <>
      <div className="drawing-bar">
        {lead}
        <div className="drawing-zoom">
          <ZoomKeys viewport={{ zoom, fit: () => onView(whole) }} />
          <GlyphButton
            glyph="target"
            name={t.showContour}
            onPress={() => partBox && onView(partBox())}
            disabled={!partBox}
          />
        </div>
      </div>
      <div
        ref={box}
        className={`drawing-sheet pick-${pick}`}
        tabIndex={0}
        role="group"
        aria-label={t.sheet}
        aria-describedby={keysId}
        onKeyDown={onKeyDown}
      >
        <canvas ref={canvas} aria-hidden="true" />
        <SheetOverlay {...marks} camera={camera} size={size} hovered={hovered} />
        <p id={keysId} className="unseen">
          {t.sheetKeys}
        </p>
      </div>
    </>
  );
}
