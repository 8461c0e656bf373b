import { useEffect, useLayoutEffect, useMemo, useRef, useState, type KeyboardEvent } from "react";
import { texts } from "../../app/base/settings/loaded-texts.ts";
import type { Language } from "../../i18n/languages.ts";
import { dimensionTyped } from "../../program/job/contour-dimensions.ts";
import type { RowsReading } from "../../program/job/contour-rows.ts";
import type { ContourRow } from "../../program/job/job.ts";
import { toScreen, type Place, type Size } from "../../view/camera.ts";
import { placedDimensions, type PlacedDimension } from "../../view/dimensions/placed-dimensions.ts";
import { WORKPIECE_ZERO } from "../../view/datum.ts";
import type { LabelBox } from "../../view/dimensions/labels.ts";
import type { ContourPicture } from "../../view/help/contour-drawing.ts";
import { NumberInput } from "../../app/fields/number/NumberInput.tsx";
import { SCALE_BELOW, SCALE_LEFT } from "../../app/pictures/lathe/Axes.tsx";
import { pageLength } from "../../app/base/unit.ts";
import { useFingers } from "../../app/base/use-media.ts";
import type { HoldSign } from "./hold-signs.ts";
import { drawnDimensions, type DrawnDimension } from "./drawing-dimensions.ts";

interface Props {
  readonly rows: readonly ContourRow[];
  readonly reading: RowsReading;
  readonly picture: ContourPicture;
  /** Signs on the drawing, which no text covers. */
  readonly signs: readonly HoldSign[];
  readonly size: Size;
  readonly chosen: number | null;
  readonly language: Language;
  /** A dimension was opened: its element is chosen. */
  readonly onPick: (row: number) => void;
  /** The rows after a dimension was typed; a separate step of undo. */
  readonly onTyped: (rows: readonly ContourRow[]) => void;
}

/** Least size of a dimension's text; for fingers as large as any target. */
const TARGET = { mouse: { width: 40, height: 22 }, fingers: { width: 56, height: 48 } } as const;
/** Margin around the texts, pixels. */
const AIR = 2;
/** Distance of the texts from the contour, pixels. */
const BESIDE = { right: 36, below: 24 } as const;
/** Least width of a field, pixels. */
const FIELD = 108;

/** The dimensions on the drawing: thin lines and texts; a clicked text becomes a field in its place. */
export function DrawingDimensions({ rows, reading, picture, signs, size, chosen, language, onPick, onTyped }: Props) {
  const t = texts(language).contour;
  const fingers = useFingers();
  const [open, setOpen] = useState<string | null>(null);
  const back = useRef<string | null>(null),
    box = useRef<HTMLDivElement>(null);
  const drawn = useMemo(
    () => drawnDimensions({ rows, reading, chosen, language, texts: t }),
    [rows, reading, chosen, language, t],
  );
  const placed = useMemo(
    () =>
      placedDimensions(
        {
          camera: picture.camera,
          size,
          unit: 1,
          room: roomOf(size),
          target: fingers ? TARGET.fingers : TARGET.mouse,
          kept: [...picture.kept, ...signs.map(({ box }) => box)],
          free: freeOf(picture),
          avoid: picture.avoid,
        },
        drawn,
      ),
    [drawn, picture, signs, size, fingers],
  );
  const places = new Map(placed.map((p) => [p.key, p]));

  useLayoutEffect(() => {
    const key = back.current;
    back.current = null;
    if (key === null) return;
    [...(box.current?.querySelectorAll<HTMLElement>("[data-dimension]") ?? [])]
      .find((each) => each.dataset["dimension"] === key)
      ?.focus();
  });

  const close = (key: string, keyboard: boolean) => {
    if (keyboard) back.current = key;
    setOpen(null);
  };
  return (
    <>
      <svg className="contour-dimensions" aria-hidden="true" viewBox={`0 0 ${size.width} ${size.height}`}>
        {drawn.map(({ key, own }) => {
          const at = places.get(key);
          return (
            at && (
              <g key={key} className={own ? "own" : ""}>
                <path className="line" d={at.lines} />
                <path className="arrow" d={at.arrows} />
              </g>
            )
          );
        })}
      </svg>
      <div className="contour-dimension-texts" ref={box}>
        {drawn.map((each) => {
          const at = places.get(each.key);
          if (!at) return null;
          if (open === each.key)
            return (
              <DimensionField
                key={each.key}
                each={each}
                at={at}
                size={size}
                name={t.inDrawing(each.name)}
                onClose={(text, keyboard) => {
                  close(each.key, keyboard);
                  if (text !== null)
                    onTyped(dimensionTyped(rows, reading, each.dimension.row, each.dimension.field, text));
                }}
              />
            );
          return (
            <button
              key={each.key}
              type="button"
              data-dimension={each.key}
              aria-label={t.dimension(each.name, each.text)}
              className={`contour-dimension number${each.own ? " own" : ""}${each.dimension.follows ? " follows" : ""}`}
              tabIndex={each.own ? 0 : -1}
              style={styleOf(at)}
              onClick={() => {
                onPick(each.dimension.row);
                setOpen(each.key);
              }}
            >
              <span>{each.text}</span>
            </button>
          );
        })}
      </div>
    </>
  );
}

/** Where texts may be: clear of the scales at the left and the lower edge. */
const roomOf = ({ width, height }: Size): LabelBox => ({
  x: SCALE_LEFT + AIR,
  y: AIR,
  width: width - SCALE_LEFT - 2 * AIR,
  height: height - SCALE_BELOW - 2 * AIR,
});

/** Lines for the texts next to the contour: right of it and of Z0, below it and the axis, pixels. */
function freeOf({ avoid, points, camera }: ContourPicture): Place {
  const zero = toScreen(camera, WORKPIECE_ZERO),
    all = [...avoid, ...points.map((p) => p.place), zero];
  return { x: Math.max(...all.map((p) => p.x)) + BESIDE.right, y: Math.max(...all.map((p) => p.y)) + BESIDE.below };
}

const styleOf = ({ box }: PlacedDimension) => ({
  left: pageLength(box.x),
  top: pageLength(box.y),
  width: pageLength(box.width),
  height: pageLength(box.height),
});

/** A dimension being typed: Enter or leaving applies it, Escape cancels. */
function DimensionField({
  each,
  at,
  size,
  name,
  onClose,
}: {
  readonly each: DrawnDimension;
  readonly at: PlacedDimension;
  readonly size: Size;
  readonly name: string;
  /** The typed text, or null if cancelled; whether focus stays at the dimension. */
  readonly onClose: (text: string | null, keyboard: boolean) => void;
}) {
  const begun = each.dimension.text;
  const [text, setText] = useState(begun);
  const input = useRef<HTMLInputElement>(null),
    closed = useRef(false);
  useEffect(() => {
    input.current?.focus({ preventScroll: true });
    input.current?.select();
  }, []);
  const take = (taken: string | null, keyboard: boolean) => {
    if (closed.current) return;
    closed.current = true;
    onClose(taken === begun ? null : taken, keyboard);
  };
  const onKey = (e: KeyboardEvent) => {
    if (e.key !== "Enter" && e.key !== "Escape") return;
    e.preventDefault();
    e.stopPropagation();
    take(e.key === "Enter" ? text : null, true);
  };
  const width = Math.max(FIELD, at.box.width),
    left = Math.max(2, Math.min(at.box.x + (at.box.width - width) / 2, size.width - width - 2));
  return (
    <NumberInput
      ref={input}
      className="input number contour-dimension-field"
      text={text}
      onText={setText}
      sums={false}
      aria-label={name}
      style={{ left: pageLength(left), top: pageLength(at.box.y + at.box.height / 2), width: pageLength(width) }}
      onKeyDown={onKey}
      onLeave={() => take(text, false)}
    />
  );
}
