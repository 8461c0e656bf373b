import { placeIn } from "../../app/base/unit.ts";
import { useEffect, useRef, useState, type MouseEvent, type PointerEvent } from "react";
import { part, type Pt } from "../../kernel/geometry/point.ts";
import { axial, diameter, radius, toDiameter, toRadius } from "../../kernel/units.ts";
import type { RowsReading } from "../../program/job/contour-rows.ts";
import type { ContourRow } from "../../program/job/job.ts";
import { panned, pinched, toPlace, type Camera, type Place } from "../../view/camera.ts";
import type { ContourPicture } from "../../view/help/contour-drawing.ts";
import { closeStep } from "../../app/document/steps.ts";
import { cornerSized, hasPoint, isCorner, pointAppended, pointInserted, pointMoved, typed } from "./drawing-edits.ts";
import type { Edited } from "./row-edits.ts";
import { snapPoint, onGrid, type Aim, type GridStep, type Ray, type SnapSpot } from "./snap.ts";
import { SAME } from "../../kernel/tolerance.ts";

/** What a pointer does in the drawing. */
export type DrawingMode = "move" | "draw" | "round" | "chamfer";
type Rows = readonly ContourRow[];

/** Snap distance between pointer and point, pixels. */
const NEAR = { mouse: 12, touch: 26 } as const;
/** A pointer that moves less than this is a tap, pixels. */
const TAP = 5;
/** Long press that divides an element, ms. */
const LONG = 500;

interface Surroundings {
  readonly rows: Rows;
  readonly reading: RowsReading;
  readonly picture: ContourPicture;
  readonly mode: DrawingMode;
  readonly step: GridStep;
  readonly onRows: (rows: Rows, place: string) => void;
  readonly onEdited: (edited: Edited) => void;
  readonly onPick: (row: number) => void;
  /** The view chosen by the operator; null while the contour fills the drawing. */
  readonly camera: Camera | null;
  readonly onCamera: (camera: Camera | null) => void;
}

/** Feedback of the gesture: its target, the snap, and the size of a corner. */
export interface Pointing {
  readonly row: number | null;
  readonly aim: Aim;
  readonly size: number | null;
}

interface Gesture {
  readonly kind: "point" | "corner" | "pan" | "tap" | "pinch";
  readonly row: number | null;
  readonly from: Place;
  readonly camera: Camera;
  /** The view before the gesture; during the gesture the view is fixed. */
  readonly looked: Camera | null;
  /** The table when the gesture began to change it: the press may have ended the typing in a field. */
  rows: Rows;
  reading: RowsReading;
  readonly place: string;
  moved: boolean;
}

const distance = (a: Place, b: Place) => Math.hypot(a.x - b.x, a.y - b.y);
const placeOf = (e: MouseEvent<SVGSVGElement>): Place => placeIn(e.currentTarget, e);
const rowUnder = (e: { target: EventTarget }): number | null => {
  const row = e.target instanceof Element ? e.target.closest("[data-row]")?.getAttribute("data-row") : null;
  return row === null || row === undefined ? null : Number(row);
};
const spotAt = (camera: Camera, place: Place): SnapSpot => {
  const p = toPlace(camera, place);
  return { x: toDiameter(radius(Math.max(0, p.r))), z: p.z };
};

/** Gestures of the contour drawing: drag points and corners, add and divide, pan. Escape cancels a drag. */
export function useDrawing(now: Surroundings) {
  const gesture = useRef<Gesture | null>(null);
  const count = useRef(0);
  /** The element under the last press: with pointer capture the event target is no longer that element. */
  const pressed = useRef<number | null>(null);
  const timer = useRef<ReturnType<typeof setTimeout> | null>(null);
  const fingers = useRef(new Map<number, Place>());
  const pinch = useRef<Camera | null>(null);
  const [pointing, point] = useState<Pointing | null>(null);
  const stopWaiting = () => {
    if (timer.current !== null) clearTimeout(timer.current);
    timer.current = null;
  };
  const end = (e: PointerEvent<SVGSVGElement> | null) => {
    stopWaiting();
    gesture.current = null;
    point(null);
    closeStep();
    if (e?.currentTarget.hasPointerCapture(e.pointerId)) e.currentTarget.releasePointerCapture(e.pointerId);
  };
  useEffect(() => stopWaiting, []);

  const aim = (place: Place, camera: Camera, row: number | null): Aim => {
    const others = now.reading.rows.flatMap((r, i) => (r.end && i !== row ? [r.end] : []));
    const reach = 7 / camera.scale;
    return snapPoint(
      spotAt(camera, place),
      now.step,
      {
        x: others.map((o) => o.x),
        z: others.map((o) => o.z),
        reach: { x: toDiameter(radius(reach)), z: axial(reach) },
      },
      rayOf(now.reading, row ?? now.rows.length),
    );
  };
  const divide = (row: number, place: Place, camera: Camera) => {
    const edited = pointInserted(
      now.rows,
      now.reading,
      row,
      nearestOn(now.reading, row, spotAt(camera, place), now.step),
    );
    if (edited.rows !== now.rows) now.onEdited(edited);
  };
  const pointNear = (place: Place, fine: boolean): number | null => {
    const near = now.picture.points
      .map((p) => ({ row: p.row, far: distance(p.place, place) }))
      .sort((a, b) => a.far - b.far)[0];
    return near && near.far <= (fine ? NEAR.mouse : NEAR.touch) ? near.row : null;
  };

  /** A second finger ends the gesture of the first, and pans and zooms. */
  const beginPinch = () => {
    const g = gesture.current;
    stopWaiting();
    if (g?.moved && (g.kind === "point" || g.kind === "corner")) now.onRows(g.rows, g.place);
    if (g) gesture.current = { ...g, kind: "pinch", moved: true };
    pinch.current = now.picture.camera;
    point(null);
  };
  const goOnPinching = (id: number, here: Place) => {
    const before = fingers.current.get(id),
      [other] = [...fingers.current].filter(([each]) => each !== id).map(([, place]) => place);
    fingers.current.set(id, here);
    if (!before || !other || !pinch.current) return;
    pinch.current = pinched(pinch.current, [before, other], [here, other]);
    now.onCamera(pinch.current);
  };

  return {
    pointing,
    onPointerDown: (e: PointerEvent<SVGSVGElement>) => {
      if (e.button !== 0) return;
      fingers.current.set(e.pointerId, placeOf(e));
      if (gesture.current) return fingers.current.size === 2 ? beginPinch() : undefined;
      const place = placeOf(e),
        found = pointNear(place, e.pointerType === "mouse"),
        element = rowUnder(e);
      const row = found !== null && now.mode !== "move" && !hasPoint(now.rows[found]) ? found - 1 : found;
      const atCorners = now.mode === "round" || now.mode === "chamfer";
      const taken = row !== null && (atCorners ? isCorner(now.rows, row) : hasPoint(now.rows[row]));
      const beside = now.mode === "draw" || element !== null ? "tap" : "pan";
      const kind = taken ? (atCorners ? "corner" : "point") : beside;
      count.current += 1;
      pressed.current = row === null ? element : null;
      gesture.current = {
        kind,
        row: row ?? element,
        from: place,
        camera: now.picture.camera,
        looked: now.camera,
        rows: now.rows,
        reading: now.reading,
        place: `drawing ${count.current}`,
        moved: false,
      };
      e.currentTarget.setPointerCapture(e.pointerId);
      if (kind === "point" || kind === "corner") now.onCamera(now.picture.camera);
      if (e.pointerType !== "mouse" && row === null && element !== null && now.mode !== "draw")
        timer.current = setTimeout(() => {
          divide(element, place, now.picture.camera);
          end(null);
        }, LONG);
    },
    onPointerMove: (e: PointerEvent<SVGSVGElement>) => {
      const g = gesture.current,
        place = placeOf(e);
      if (!g) {
        const hovers = e.pointerType === "mouse" && now.mode === "draw";
        return hovers ? point({ row: null, aim: aim(place, now.picture.camera, null), size: null }) : undefined;
      }
      if (g.kind === "pinch") return goOnPinching(e.pointerId, place);
      if (fingers.current.has(e.pointerId)) fingers.current.set(e.pointerId, place);
      if (!g.moved) {
        if (distance(place, g.from) < TAP) return;
        Object.assign(g, { moved: true, rows: now.rows, reading: now.reading });
      }
      stopWaiting();
      if (g.kind === "pan" || (g.kind === "tap" && now.mode !== "draw"))
        return now.onCamera(panned(g.camera, place.x - g.from.x, place.y - g.from.y));
      if (g.row === null) return;
      if (g.kind === "point") {
        const found = aim(place, g.camera, g.row);
        point({ row: g.row, aim: found, size: null });
        now.onRows(pointMoved(g.rows, g.reading, g.row, found.spot), g.place);
      } else if (g.kind === "corner") {
        const size = onGrid(distance(place, g.from) / g.camera.scale, Math.min(now.step, 0.5));
        const edited = cornerSized(g.rows, g.row, now.mode === "round" ? "RND" : "CHF", size);
        const made = edited.rows.find((r) => r.id === edited.focus);
        const corner = g.reading.rows[g.row]?.end;
        const at: Aim | null = corner ? { spot: corner, onX: false, onZ: false, ray: null } : null;
        if (at) point({ row: g.row, aim: at, size: size > 0 ? Number(made?.r ?? typed(size)) : 0 });
        now.onRows(edited.rows, g.place);
      }
    },
    onPointerUp: (e: PointerEvent<SVGSVGElement>) => {
      const g = gesture.current;
      fingers.current.delete(e.pointerId);
      if (g?.kind === "pinch" && fingers.current.size > 0) return;
      end(e);
      if (!g || g.moved) {
        if (g && (g.kind === "point" || g.kind === "corner") && g.row !== null) now.onPick(g.row);
        if (g && (g.kind === "point" || g.kind === "corner")) now.onCamera(g.looked);
        return;
      }
      if (g.kind === "point" || g.kind === "corner") now.onCamera(g.looked);
      if (now.mode === "draw" && g.kind === "tap") {
        const element = g.row;
        // The view stays, so that the next point is placed in the same scale.
        now.onCamera(g.camera);
        if (element !== null && element > 0) return divide(element, g.from, g.camera);
        return now.onEdited(pointAppended(now.rows, aim(g.from, g.camera, null).spot));
      }
      if (g.row !== null) now.onPick(g.row);
    },
    onPointerCancel: (e: PointerEvent<SVGSVGElement>) => {
      const g = gesture.current;
      fingers.current.delete(e.pointerId);
      if (g?.moved && (g.kind === "point" || g.kind === "corner")) now.onRows(g.rows, g.place);
      end(e);
    },
    onPointerLeave: () => gesture.current === null && point(null),
    onDoubleClick: (e: MouseEvent<SVGSVGElement>) => {
      const place = placeOf(e),
        element = pressed.current;
      if (now.mode !== "draw" && element !== null && pointNear(place, true) === null)
        divide(element, place, now.picture.camera);
    },
    /** Escape: cancels the current drag. */
    takeBack: (): boolean => {
      const g = gesture.current;
      if (!g) return false;
      if (g.moved && (g.kind === "point" || g.kind === "corner")) now.onRows(g.rows, g.place);
      now.onCamera(g.looked);
      end(null);
      return true;
    },
  };
}

/** A spot, whose X is a diameter, in the half plane. */
const pointOf = ({ x, z }: SnapSpot): Pt => ({ z: axial(z), r: toRadius(diameter(x)) });

/**
 * The tangential continuation at the element of a row; null if it runs along an axis, or there is no previous element.
 */
function rayOf(reading: RowsReading, row: number): Ray | null {
  const i = reading.rowOfSegment.findLastIndex((each) => each < row),
    before = reading.contour.segments[i];
  if (!before) return null;
  const along = part.direction(before, before.to);
  return Math.abs(along.z) < SAME || Math.abs(along.r) < SAME ? null : { from: before.to, along };
}

/** The point of a row's element nearest to a spot; along paraxial lines on the grid. */
function nearestOn(reading: RowsReading, row: number, spot: SnapSpot, step: number): SnapSpot {
  const to = reading.rows[row]?.end,
    from = reading.rows
      .slice(0, row)
      .map((r) => r.end)
      .filter((p) => p !== null)
      .at(-1);
  if (!to || !from) return spot;
  const s = reading.contour.segments.find((_, i) => reading.rowOfSegment[i] === row);
  if (s?.kind === "arc") {
    const own = Math.hypot(s.from.z - s.centre.z, s.from.r - s.centre.r),
      { r } = pointOf(spot);
    const angle = Math.atan2(r - s.centre.r, spot.z - s.centre.z);
    return { x: toDiameter(radius(s.centre.r + own * Math.sin(angle))), z: s.centre.z + own * Math.cos(angle) };
  }
  const [a, b, at] = [pointOf(from), pointOf(to), pointOf(spot)];
  const [dz, dr] = [b.z - a.z, b.r - a.r];
  const square = dz * dz + dr * dr;
  const k = square === 0 ? 0 : Math.min(1, Math.max(0, ((at.z - a.z) * dz + (at.r - a.r) * dr) / square));
  const on = { x: from.x + (to.x - from.x) * k, z: from.z + dz * k };
  if (Math.abs(dr) < SAME) return { ...on, z: onGrid(on.z, step) };
  return Math.abs(dz) < SAME ? { ...on, x: onGrid(on.x, step) } : on;
}
