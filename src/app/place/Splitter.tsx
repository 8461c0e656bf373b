import { useLayoutEffect, useRef, useState } from "react";
import { usePageUnit } from "../base/unit.ts";
import { useTexts } from "../base/settings/use-texts.ts";
import type { WorkKind } from "./place.ts";
import { limited, NARROWEST, setColumn, useColumns, widest, widthByKey, type Side } from "./columns.ts";

/** A pointer that moves less only presses, CSS pixels. */
const STILL = 3;

/** Shows a width without rendering; undefined: that of the style sheet. */
function show(handle: HTMLElement, side: Side, width: number | undefined): void {
  const style = handle.parentElement?.style;
  if (width === undefined) style?.removeProperty(`--${side}-width`);
  else style?.setProperty(`--${side}-width`, `${width / 16}rem`);
}

/** The width of the column and of its workplace, units of lettering; the lower limit until they are measured. */
function useMeasured(handle: React.RefObject<HTMLElement | null>, side: Side) {
  const unit = usePageUnit();
  const [measured, measure] = useState({ width: NARROWEST[side], room: 0 });
  useLayoutEffect(() => {
    const workplace = handle.current?.parentElement,
      column = workplace?.querySelector<HTMLElement>(`:scope > .${side}`);
    if (!workplace || !column || typeof ResizeObserver !== "function") return undefined;
    const observer = new ResizeObserver(() =>
      measure({ width: Math.round(column.offsetWidth / unit), room: Math.round(workplace.offsetWidth / unit) }),
    );
    observer.observe(column);
    return () => observer.disconnect();
  }, [handle, side, unit]);
  return { ...measured, unit };
}

/** The border between a column and the picture: dragged, or moved by arrow keys. A child of the workplace. */
export function Splitter({ of, side }: { readonly of: WorkKind; readonly side: Side }) {
  const t = useTexts("first").page.columns;
  const chosen = useColumns((c) => c[of][side]);
  const handle = useRef<HTMLDivElement>(null),
    pressed = useRef<number | null>(null),
    dragged = useRef<number | null>(null);
  const { width, room, unit } = useMeasured(handle, side);
  useLayoutEffect(() => {
    const { current } = handle;
    if (!current) return undefined;
    show(current, side, chosen);
    return () => show(current, side, undefined);
  }, [chosen, side]);
  const release = () => {
    pressed.current = null;
    dragged.current = null;
  };
  return (
    <div
      ref={handle}
      className={`splitter splitter-${side}`}
      role="separator"
      aria-orientation="vertical"
      aria-label={t[side]}
      aria-valuenow={width}
      aria-valuemin={NARROWEST[side]}
      aria-valuemax={Math.max(width, widest(side, room))}
      title={t.hint}
      tabIndex={0}
      onKeyDown={(event) => {
        const next = widthByKey(event.key, side, { width, room });
        if (next === null) return;
        event.preventDefault();
        event.stopPropagation();
        setColumn(of, side, next);
      }}
      onDoubleClick={() => setColumn(of, side, undefined)}
      onPointerDown={({ button, clientX, currentTarget, pointerId }) => {
        if (button !== 0) return;
        currentTarget.setPointerCapture(pointerId);
        pressed.current = clientX;
      }}
      onPointerMove={({ clientX, currentTarget }) => {
        if (pressed.current === null) return;
        if (dragged.current === null && Math.abs(clientX - pressed.current) < STILL) return;
        const { left, right } = (currentTarget.parentElement ?? currentTarget).getBoundingClientRect();
        dragged.current = limited(side, (side === "left" ? clientX - left : right - clientX) / unit, room);
        show(currentTarget, side, dragged.current);
      }}
      onPointerUp={() => {
        if (dragged.current !== null) setColumn(of, side, dragged.current);
        release();
      }}
      onPointerCancel={({ currentTarget }) => {
        show(currentTarget, side, chosen);
        release();
      }}
    />
  );
}
