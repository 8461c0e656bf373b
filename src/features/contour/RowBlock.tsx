import { useEffect, useRef, useState, type ReactNode } from "react";

/** Rows of one block: more than a screen has, so that the next rows are there before they are reached. */
export const BLOCK = 50;
/** Height of a row until its block was shown, px. */
const ROW = 41;
/** Whether the page is told what comes into view; otherwise every block is rendered. */
const IS_TOLD = typeof IntersectionObserver === "function";

interface Props {
  readonly count: number;
  /** Rendered wherever it stands: the row in use and its neighbours are in it. */
  readonly inUse: boolean;
  readonly rows: () => ReactNode;
}

/**
 * A part of a long table. Its rows are rendered while it is in view or next to it: thousands of rows with their fields
 * cost seconds at each change. Out of view it keeps its height.
 */
export function RowBlock({ count, inUse, rows }: Props) {
  const body = useRef<HTMLTableSectionElement>(null);
  const [isNear, setNear] = useState(!IS_TOLD);
  const [height, setHeight] = useState(count * ROW);
  const isShown = isNear || inUse;
  useEffect(() => {
    const element = body.current;
    if (!IS_TOLD || !element) return;
    const observer = new IntersectionObserver(
      (seen) => {
        const last = seen.at(-1);
        if (!last) return;
        if (element.childElementCount > 0) setHeight(last.boundingClientRect.height);
        setNear(last.isIntersecting);
      },
      { rootMargin: "100% 0px" },
    );
    observer.observe(element);
    return () => observer.disconnect();
  }, []);
  return (
    <tbody ref={body} role="rowgroup" {...(!isShown && { style: { height } })}>
      {isShown && rows()}
    </tbody>
  );
}
