import { useRef, useState, type CSSProperties, type KeyboardEvent, type PointerEvent } from "react";
import { factorOf } from "../../../view/drawing/scales.ts";
import { segmentData } from "../../../view/path.ts";
import { measuredSegments } from "../../../view/drawing/measured-feature.ts";
import type { PartDrawing } from "../../../view/drawing/part-drawing.ts";
import type { ListedSize } from "../../../view/drawing/print-sizes.ts";
import type { Segment } from "../../../kernel/geometry/point.ts";
import { PaperShapes, Written } from "../../../app/pictures/paper/PaperDrawing.tsx";
import { DRAG } from "./use-sheet-zoom.ts";

/** A press this near to a size chooses it, pixels. */
const NEAR = 22;

const STEPS: Readonly<Record<string, number>> = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 };

interface Props {
  readonly print: PartDrawing;
  readonly name: string;
  /** The outlines of the drawn part. */
  readonly outlines: readonly (readonly Segment[])[];
  /** Indexes into the list of sizes. */
  readonly marked: ReadonlySet<number>;
  readonly nameOf: (size: ListedSize) => string;
  /** A size was chosen; `byKey`: by moving the focus to it. */
  readonly onChoose: (index: number, byKey: boolean) => void;
  readonly style: CSSProperties;
}

/** A workshop drawing whose sizes can be chosen; those that are marked show their elements. */
export function LinkedPrint({ print, name, outlines, marked, nameOf, onChoose, style }: Props) {
  const svg = useRef<SVGSVGElement>(null);
  const pressed = useRef<{ readonly x: number; readonly y: number } | null>(null);
  const [reached, reach] = useState(0);
  const sizes = print.texts.flatMap((text) => {
    const index = print.list.findIndex(({ size }) => size === text.size),
      listed = print.list[index];
    return listed?.measures ? [{ text, index, listed }] : [];
  });
  const plain = print.texts.filter((text) => !sizes.some((each) => each.text === text));
  const elements = [...marked].flatMap((index) => {
    const feature = print.list[index]?.measures;
    return feature
      ? outlines.flatMap((outline) => measuredSegments(feature, outline).flatMap((i) => outline[i] ?? []))
      : [];
  });
  const k = factorOf(print.scale),
    { x, y } = print.origin;
  /** The nearest size to a place of the window. */
  const sizeNear = (at: { readonly x: number; readonly y: number }): number | null => {
    const frame = svg.current?.getBoundingClientRect();
    if (!frame) return null;
    const scale = frame.width / print.width;
    const far = sizes.map(({ text: { box } }) => {
      const [px, py] = [(at.x - frame.left) / scale, (at.y - frame.top) / scale];
      return (
        scale *
        Math.hypot(Math.max(box.x - px, 0, px - box.x - box.width), Math.max(box.y - py, 0, py - box.y - box.height))
      );
    });
    const least = Math.min(NEAR, ...far);
    return sizes[far.indexOf(least)]?.index ?? null;
  };
  const release = (event: PointerEvent) => {
    const from = pressed.current;
    pressed.current = null;
    if (!from || Math.hypot(event.clientX - from.x, event.clientY - from.y) > DRAG) return;
    const index = sizeNear({ x: event.clientX, y: event.clientY });
    if (index !== null) onChoose(index, false);
  };
  const move = (event: KeyboardEvent<SVGGElement>, place: number) => {
    const step = STEPS[event.key];
    if (event.key === "Enter" || event.key === " ") {
      event.preventDefault();
      const index = sizes[place]?.index;
      if (index !== undefined) onChoose(index, false);
    }
    if (step === undefined || event.shiftKey) return;
    event.preventDefault();
    const next = (place + step + sizes.length) % sizes.length;
    svg.current?.querySelectorAll<SVGGElement>(".workshop-size")[next]?.focus();
  };
  return (
    <svg
      ref={svg}
      role="group"
      aria-label={name}
      viewBox={`0 0 ${print.width} ${print.height}`}
      style={style}
      onPointerDown={(event) => void (pressed.current = { x: event.clientX, y: event.clientY })}
      onPointerUp={release}
      onPointerCancel={() => void (pressed.current = null)}
    >
      <PaperShapes shapes={print.shapes} />
      <path
        className="workshop-chosen"
        d={segmentData(elements) + segmentData(elements.map(mirrored))}
        transform={`translate(${x} ${y}) scale(${k} ${-k})`}
      />
      {plain.map((text, i) => (
        <Written key={i} text={text} />
      ))}
      {sizes.map(({ text, index, listed }, place) => (
        <g
          key={`${index} ${place}`}
          className="workshop-size"
          role="button"
          tabIndex={place === Math.min(reached, sizes.length - 1) ? 0 : -1}
          aria-label={nameOf(listed)}
          aria-pressed={marked.has(index)}
          // A press keeps the focus where it is, or moves it to the prompt that it opens.
          onMouseDown={(event) => event.preventDefault()}
          onFocus={() => {
            reach(place);
            onChoose(index, true);
          }}
          onKeyDown={(event) => move(event, place)}
        >
          <rect {...text.box} rx="0.8" />
          <Written text={text} />
        </g>
      ))}
    </svg>
  );
}

const opposite = ({ z, r }: Segment["from"]) => ({ z, r: -r }) as Segment["from"];
/** A segment on the other side of the axis. */
const mirrored = (s: Segment): Segment =>
  s.kind === "line"
    ? { ...s, from: opposite(s.from), to: opposite(s.to) }
    : {
        ...s,
        from: opposite(s.from),
        to: opposite(s.to),
        centre: opposite(s.centre),
        turn: s.turn === "cw" ? "ccw" : "cw",
      };
