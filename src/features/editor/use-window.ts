import { usePageUnit } from "../../app/base/unit.ts";
import { useCallback, useEffect, useLayoutEffect, useRef, useState, type RefObject } from "react";

/** Height of one row of the list in units of the page; `editor.css` repeats it. */
const ROW_UNITS = 48;
/** Rows rendered above and below the visible ones. */
const MARGIN = 12;
/** Rows rendered before the list has been measured. */
const FIRST = 40;

interface Window {
  readonly box: RefObject<HTMLDivElement | null>;
  readonly from: number;
  readonly to: number;
  /** Space for the rows that are not rendered, px. */
  readonly above: number;
  readonly below: number;
  readonly measure: () => void;
}

/** Renders only the visible rows of a long list, and keeps the current one visible. */
export function useWindow(count: number, current: number): Window {
  const box = useRef<HTMLDivElement>(null);
  const row = ROW_UNITS * usePageUnit();
  const [seen, see] = useState({ top: 0, rows: FIRST });
  const measure = useCallback(() => {
    const element = box.current;
    if (!element) return;
    const next = {
      top: Math.floor(element.scrollTop / row),
      rows: Math.max(FIRST, Math.ceil(element.clientHeight / row)),
    };
    see((now) => (now.top === next.top && now.rows === next.rows ? now : next));
  }, [row]);
  useLayoutEffect(measure, [count, measure]);
  useEffect(() => {
    const element = box.current;
    if (!element || current < 0) return;
    const top = current * row;
    if (top < element.scrollTop || top + row > element.scrollTop + element.clientHeight)
      element.scrollTop = Math.max(0, top - element.clientHeight / 3);
  }, [current, row]);
  const from = Math.max(0, Math.min(seen.top - MARGIN, count - seen.rows - MARGIN));
  const to = Math.min(count, seen.top + seen.rows + MARGIN);
  return { box, from, to, above: from * row, below: (count - to) * row, measure };
}
