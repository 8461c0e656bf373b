import { panned, type Camera } from "../../view/camera.ts";
import type { ContourRow } from "../../program/job/job.ts";
import type { RowsReading } from "../../program/job/contour-rows.ts";
import { cornerOf, cornerRowOf, pointAdded, pointMoved, undercutBehind, type CornerKind } from "./drawing-edits.ts";
import { withoutRow, type Edited } from "./row-edits.ts";
import { onGrid, type GridStep } from "./snap.ts";

/** Zoom factor of one key press. */
const ZOOM = 1.4;
/** Pan distance of one arrow press with Shift, pixels. */
const PAN = 40;
const PANS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [PAN, 0],
  ArrowRight: [-PAN, 0],
  ArrowUp: [0, PAN],
  ArrowDown: [0, -PAN],
};
/** Direction of an arrow on the screen. */
const MOVES: Readonly<Record<string, { readonly z: number; readonly up: number }>> = {
  ArrowLeft: { z: -1, up: 0 },
  ArrowRight: { z: 1, up: 0 },
  ArrowUp: { z: 0, up: 1 },
  ArrowDown: { z: 0, up: -1 },
};
const CORNERS: Readonly<Record<string, CornerKind>> = { r: "RND", c: "CHF" };

interface Pressed {
  readonly rows: readonly ContourRow[];
  readonly reading: RowsReading;
  readonly active: number | null;
  readonly camera: Camera;
  readonly step: GridStep;
  readonly xUp: boolean;
  readonly onPick: (row: number) => void;
  readonly onEdited: (edited: Edited) => void;
  /** Moves of the same `place` are one step of undo. */
  readonly onRows: (rows: readonly ContourRow[], place: string) => void;
  readonly onZoom: (factor: number) => void;
  readonly onCamera: (camera: Camera | null) => void;
}

/** The rows with the end point of the selected one moved by a step of the grid; null without a point. */
function movedBy(on: Pressed, { z, up }: { readonly z: number; readonly up: number }): readonly ContourRow[] | null {
  const end = on.active === null ? null : on.reading.rows[on.active]?.end;
  if (!end || on.active === null) return null;
  const x = on.xUp ? up : -up;
  const to = {
    x: x === 0 ? end.x : Math.max(0, onGrid(end.x + x * on.step, on.step)),
    z: z === 0 ? end.z : onGrid(end.z + z * on.step, on.step),
  };
  const rows = pointMoved(on.rows, on.reading, on.active, to);
  return rows === on.rows ? null : rows;
}

/** The edit of a key that changes elements: a corner, a new point, or a deleted element; null for another key. */
function editOf(key: string, { rows, reading, active, step }: Pressed): Edited | null {
  const kind = CORNERS[key];
  if (kind) return cornerOf(rows, active, kind);
  if (key === "insert" || key === "n") return pointAdded(rows, reading, active, step);
  if (active === null) return null;
  if (key === "delete") return withoutRow(rows, active);
  const corner = key === "u" ? cornerRowOf(rows, active) : null;
  return corner === null ? null : undercutBehind(rows, corner);
}

/**
 * Keys of the drawing: arrows select an element, with Alt they move its point by the grid, with Shift they pan; letters
 * break a corner or put an undercut in, N and Insert add a point, Delete removes the element. Returns whether the key
 * acted.
 */
export function pressDrawingKey(
  { key, shiftKey, altKey }: { readonly key: string; readonly shiftKey: boolean; readonly altKey: boolean },
  on: Pressed,
): boolean {
  const pan = PANS[key],
    move = MOVES[key];
  if (altKey) {
    if (!move) return false;
    const rows = movedBy(on, move);
    if (rows) on.onRows(rows, `drawing keys ${on.active}`);
    // Without a point to move, the arrow is still no page of the browser's history.
    return true;
  }
  if (pan && shiftKey) {
    on.onCamera(panned(on.camera, pan[0], pan[1]));
    return true;
  }
  if (pan) {
    const next = (on.active ?? -1) + (key === "ArrowRight" || key === "ArrowDown" ? 1 : -1);
    if (on.rows[next]) on.onPick(next);
    return true;
  }
  const edited = editOf(key.toLowerCase(), on);
  if (edited) on.onEdited(edited);
  else if (key === "+" || key === "=") on.onZoom(ZOOM);
  else if (key === "-") on.onZoom(1 / ZOOM);
  else if (key === "0") on.onCamera(null);
  else return false;
  return true;
}
