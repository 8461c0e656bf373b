import { useEffect, useEffectEvent, type RefObject } from "react";

/** A swipe at least this far across, and less than half of it up or down, turns the page, px. */
const FAR = 60;

/** Elements that handle the arrow keys themselves. */
const TAKES_KEYS = "input, select, textarea, [role=slider], dialog";

/** Whether the arrow keys are needed elsewhere: by a field, or to scroll a program sideways. */
function takesKeys(target: EventTarget | null): boolean {
  if (!(target instanceof Element)) return false;
  const program = target.closest("pre");
  return target.closest(TAKES_KEYS) !== null || (program !== null && program.scrollWidth > program.clientWidth + 1);
}

/** Whether the page can scroll further: then the page keys scroll. */
const scrolls = (page: HTMLElement | null): boolean =>
  page !== null &&
  [page, ...page.querySelectorAll("*")].some(
    (each) => each.scrollHeight > each.clientHeight + 1 && getComputedStyle(each).overflowY === "auto",
  );

/**
 * The arrow and page keys, and a swipe across the text, turn pages, even if the page is rendered again during the
 * swipe.
 */
export function usePageTurning(page: RefObject<HTMLElement | null>, onTurn: (by: -1 | 1) => void): void {
  const turn = useEffectEvent(onTurn);
  useEffect(() => {
    const onKey = (event: KeyboardEvent) => {
      const { key, target } = event;
      if (event.ctrlKey || event.metaKey || event.altKey || event.shiftKey || event.defaultPrevented) return;
      if (document.querySelector("dialog[open]") || takesKeys(target)) return;
      const isPageKey = key === "PageDown" || key === "PageUp";
      if (isPageKey && scrolls(page.current)) return;
      if (key === "ArrowRight" || key === "PageDown") turn(1);
      else if (key === "ArrowLeft" || key === "PageUp") turn(-1);
      else return;
      event.preventDefault();
    };
    document.addEventListener("keydown", onKey);
    return () => document.removeEventListener("keydown", onKey);
  }, [page]);

  useEffect(() => {
    const element = page.current;
    if (!element) return undefined;
    let from: { readonly x: number; readonly y: number } | null = null;
    const begin = ({ touches, target }: TouchEvent) => {
      const [touch] = touches;
      const isFree = touches.length === 1 && touch && !takesKeys(target);
      from = isFree ? { x: touch.clientX, y: touch.clientY } : null;
    };
    const end = ({ changedTouches: [touch] }: TouchEvent) => {
      if (!from || !touch) return;
      const [across, down] = [touch.clientX - from.x, touch.clientY - from.y];
      from = null;
      if (Math.abs(across) >= FAR && Math.abs(down) * 2 < Math.abs(across)) turn(across < 0 ? 1 : -1);
    };
    const lose = () => {
      from = null;
    };
    element.addEventListener("touchstart", begin, { passive: true });
    element.addEventListener("touchend", end, { passive: true });
    element.addEventListener("touchcancel", lose, { passive: true });
    return () => {
      element.removeEventListener("touchstart", begin);
      element.removeEventListener("touchend", end);
      element.removeEventListener("touchcancel", lose);
    };
  }, [page]);
}
