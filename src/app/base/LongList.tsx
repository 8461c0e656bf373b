import { useEffect, useRef, useState, type ComponentProps, type ReactNode } from "react";

/** Rows at first, and with each press of a button: thousands at once stop the page for seconds. */
const PORTION = 200;

const portionOf = (at: number) => Math.floor(Math.max(0, at) / PORTION);

interface Props<T> extends Omit<ComponentProps<"ul">, "children"> {
  readonly all: readonly T[];
  readonly row: (each: T, at: number) => ReactNode;
  /** Words of the button that shows `n` more rows. */
  readonly more: (n: number) => string;
  /** Words of the button that shows `n` rows before them; only where `around` is given. */
  readonly earlier?: (n: number) => string;
  /** A row that is shown, by its place. */
  readonly around?: number;
  readonly isOrdered?: boolean;
}

/** A list of any length, of which buttons show further rows. They get the focus, which the button may lose. */
export function LongList<T>({ all, row, more, earlier, around = 0, isOrdered = false, ...list }: Props<T>) {
  // Portions, the last one excluded.
  const [shown, show] = useState({ from: portionOf(around), to: portionOf(around) + 1 });
  const [asked, ask] = useState(around);
  const focus = useRef<number | null>(null);
  const rows = useRef<HTMLUListElement>(null);
  if (around !== asked) {
    ask(around);
    const portion = portionOf(around);
    if (portion < shown.from || portion >= shown.to) show({ from: portion, to: portion + 1 });
  }
  const from = shown.from * PORTION,
    to = shown.to * PORTION,
    left = all.length - to;
  useEffect(() => {
    if (focus.current === null) return;
    rows.current?.children[focus.current]?.querySelector<HTMLElement>("button:enabled, input:enabled")?.focus();
    focus.current = null;
  }, [shown]);
  const go = (next: typeof shown, focused: number) => {
    focus.current = focused;
    show(next);
  };
  // Both take the same attributes.
  const List = (isOrdered ? "ol" : "ul") as "ul";
  return (
    <>
      {from > 0 && (
        <button
          type="button"
          className="button"
          onClick={() => go({ from: shown.from - 1, to: shown.to }, PORTION - 1)}
        >
          {earlier?.(PORTION)}
        </button>
      )}
      <List ref={rows} {...list}>
        {all.slice(from, to).map((each, i) => row(each, from + i))}
      </List>
      {left > 0 && (
        <button type="button" className="button" onClick={() => go({ from: shown.from, to: shown.to + 1 }, to - from)}>
          {more(Math.min(PORTION, left))}
        </button>
      )}
    </>
  );
}
