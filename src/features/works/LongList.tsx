import { useEffect, useRef, useState, type ComponentProps, type ReactNode } from "react";

/** Rows at first, and with each press of the button: thousands at once stop the page for seconds. */
const PORTION = 200;

interface Props<T> extends Omit<ComponentProps<"ul">, "children"> {
  readonly all: readonly T[];
  readonly row: (each: T, at: number) => ReactNode;
  /** Words of the button that shows `n` more rows. */
  readonly more: (n: number) => string;
}

/** A list of any length, of which a button shows further rows. They get the focus, which the button may lose. */
export function LongList<T>({ all, row, more, ...list }: Props<T>) {
  const [most, show] = useState(PORTION);
  const rows = useRef<HTMLUListElement>(null);
  const left = all.length - most;
  useEffect(() => {
    if (most > PORTION)
      rows.current?.children[most - PORTION]?.querySelector<HTMLElement>("button:enabled, input:enabled")?.focus();
  }, [most]);
  return (
    <>
      <ul ref={rows} {...list}>
        {all.slice(0, most).map(row)}
      </ul>
      {left > 0 && (
        <button type="button" className="button" onClick={() => show(most + PORTION)}>
          {more(Math.min(PORTION, left))}
        </button>
      )}
    </>
  );
}
