import { usePageUnit } from "../../app/base/unit.ts";
import { useCallback, useEffect, useLayoutEffect, useRef, useState, type RefObject } from "react";

/** Height of one row of the list in units of the page; the same stands in `editor.css`. */
const ROW_UNITS = 48;
/** Rows above and below what is seen. */
const MARGIN = 12;
/** Rows that are made before the list has been measured. */
const FIRST = 40;

interface Window {
  readonly box: RefObject<HTMLDivElement | null>;
  readonly from: number;
  readonly to: number;
  /** Room that the rows take that are not made, px. */
  readonly above: number;
  readonly below: number;
  readonly measure: () => void;
}

/** Makes only the rows of a long list that are in sight, and keeps the current one in sight. */
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
