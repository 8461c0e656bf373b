import { panned, type Camera } from "../../view/camera.ts";
import type { ContourRow } from "../../program/job/job.ts";
import { cornerOf, type CornerKind } from "./drawing-edits.ts";
import type { Edited } from "./row-edits.ts";

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
const CORNERS: Readonly<Record<string, CornerKind>> = { r: "RND", c: "CHF" };

interface Pressed {
  readonly rows: readonly ContourRow[];
  readonly active: number | null;
  readonly camera: Camera;
  readonly onPick: (row: number) => void;
  readonly onEdited: (edited: Edited) => void;
  readonly onZoom: (factor: number) => void;
  readonly onCamera: (camera: Camera | null) => void;
}

/**
 * Keys of the drawing: arrows select an element, with Shift they pan; R and C break a corner. Returns whether the key
 * acted.
 */
export function pressDrawingKey(
  { key, shiftKey }: { readonly key: string; readonly shiftKey: boolean },
  on: Pressed,
): boolean {
  const pan = PANS[key],
    kind = CORNERS[key.toLowerCase()];
  if (pan && shiftKey) {
    on.onCamera(panned(on.camera, pan[0], pan[1]));
    return true;
  }
  if (pan) {
    const next = (on.active ?? -1) + (key === "ArrowRight" || key === "ArrowDown" ? 1 : -1);
    if (on.rows[next]) on.onPick(next);
    return true;
  }
  if (kind) {
    const edited = on.active === null ? null : cornerOf(on.rows, on.active, kind);
    if (edited) on.onEdited(edited);
    return edited !== null;
  }
  if (key === "+" || key === "=") on.onZoom(ZOOM);
  else if (key === "-") on.onZoom(1 / ZOOM);
  else if (key === "0") on.onCamera(null);
  else return false;
  return true;
}
