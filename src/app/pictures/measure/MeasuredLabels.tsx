import { useRef, useState, type KeyboardEvent, type PointerEvent } from "react";
import type { Pt } from "../../../kernel/geometry/point.ts";
import { toPlace, type Camera, type Place } from "../../../view/camera.ts";
import { middleOf } from "../../../view/dimensions/labels.ts";
import type { PlacedDimension } from "../../../view/dimensions/placed-dimensions.ts";
import { setMeasured } from "../../document/edits.ts";
import { pageLength, pageUnit } from "../../base/unit.ts";
import { Icon } from "../../base/Icon.tsx";
import type { MeasurementWords } from "./measure-words.ts";
import { useTexts } from "../../base/settings/use-texts.ts";

/** A label while it is dragged. */
export interface DraggedLabel {
  readonly id: string;
  readonly to: Pt;
}

/** A press that moves less is no drag; step of an arrow key; pixels. */
const TAP = 4,
  STEP = 8;
const ARROWS: Readonly<Record<string, Place>> = {
  ArrowLeft: { x: -STEP, y: 0 },
  ArrowRight: { x: STEP, y: 0 },
  ArrowUp: { x: 0, y: -STEP },
  ArrowDown: { x: 0, y: STEP },
};

const put = ({ id, to }: DraggedLabel): void =>
  setMeasured((list) => list.map((each) => (each.id === id ? { ...each, text: to } : each)), `measured ${id}`);
/** Removes a measurement from the picture. */
export const removeMeasurement = (id: string): void => setMeasured((list) => list.filter((each) => each.id !== id));

/** The label of one measurement, which can be dragged and removed. */
function MeasuredLabel({
  standing: { key: id, box },
  words: { name, text, caption },
  isOld,
  camera,
  isMoving,
  move,
}: {
  readonly standing: PlacedDimension;
  readonly words: MeasurementWords;
  readonly isOld: boolean;
  readonly camera: Camera;
  readonly isMoving: boolean;
  readonly move: (moved: DraggedLabel | null) => void;
}) {
  const t = useTexts("measure"),
    middle = middleOf(box),
    [open, show] = useState(false);
  const drag = useRef<{ readonly from: Place; readonly middle: Place; last: Pt | null } | null>(null);
  const press = (event: PointerEvent<HTMLButtonElement>) => {
    if (event.button !== 0) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    drag.current = { from: { x: event.clientX, y: event.clientY }, middle, last: null };
  };
  const follow = (event: PointerEvent) => {
    const now = drag.current;
    if (!now) return;
    const unit = pageUnit(),
      by = { x: (event.clientX - now.from.x) / unit, y: (event.clientY - now.from.y) / unit };
    if (!now.last && Math.hypot(by.x, by.y) < TAP) return;
    now.last = toPlace(camera, { x: now.middle.x + by.x, y: now.middle.y + by.y });
    move({ id, to: now.last });
  };
  const release = (event: PointerEvent) => {
    const last = drag.current?.last ?? null;
    drag.current = null;
    if (last && event.type === "pointerup") put({ id, to: last });
    else if (event.type === "pointerup") show(!open);
    move(null);
  };
  const key = (event: KeyboardEvent) => {
    const arrow = ARROWS[event.key];
    if (arrow) put({ id, to: toPlace(camera, { x: middle.x + arrow.x, y: middle.y + arrow.y }) });
    else if (event.key === "Delete" || event.key === "Backspace") removeMeasurement(id);
    else if (event.key === "Enter" || event.key === " ") show(!open);
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <div
      className={isOld ? "measured-label old" : "measured-label"}
      data-moving={isMoving || undefined}
      style={{
        left: pageLength(middle.x),
        top: pageLength(middle.y),
        minWidth: pageLength(box.width),
        minHeight: pageLength(box.height),
      }}
    >
      <button
        type="button"
        className="measured-text number"
        aria-label={name}
        title={t.label}
        aria-expanded={open}
        onPointerDown={press}
        onPointerMove={follow}
        onPointerUp={release}
        onPointerCancel={release}
        onKeyDown={key}
      >
        {text}
        {caption && <span className="measured-caption">{caption}</span>}
      </button>
      {open && (
        <button
          type="button"
          className="button icon measured-remove"
          aria-label={t.remove(name)}
          title={t.remove(name)}
          onClick={() => removeMeasurement(id)}
        >
          <Icon name="close" />
        </button>
      )}
    </div>
  );
}

/** The labels of all measurements of a picture. */
export function MeasuredLabels({
  standing,
  words,
  old,
  camera,
  moved,
  move,
}: {
  readonly standing: readonly PlacedDimension[];
  readonly words: ReadonlyMap<string, MeasurementWords>;
  readonly old: ReadonlySet<string>;
  readonly camera: Camera;
  readonly moved: DraggedLabel | null;
  readonly move: (moved: DraggedLabel | null) => void;
}) {
  return (
    <>
      {standing.map((each) => {
        const said = words.get(each.key);
        return (
          said && (
            <MeasuredLabel
              key={each.key}
              standing={each}
              words={said}
              isOld={old.has(each.key)}
              camera={camera}
              isMoving={moved?.id === each.key}
              move={move}
            />
          )
        );
      })}
    </>
  );
}
