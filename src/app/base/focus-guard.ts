/*
 * The keyboard is never lost. A focused element may disappear: its dialog closes, its prompt is answered, its button
 * disables itself. The browser then leaves the focus on the page, where a keyboard has to begin again. Here the focus
 * goes to what has taken the element's place, unless a component has put it elsewhere by then.
 */

/** Marks the element that gets the focus first where its part of the page replaces another one. */
export const FIRST_FOCUS = "data-first-focus";

const MAIN = "main, [role=main]";
const FOCUSABLE = "a[href], button, input, select, textarea, summary, [tabindex], [contenteditable=true]";
/** Focused elements that are remembered: the last one, and those behind dialogs and pages that closed. */
const MOST_REMEMBERED = 12;

/** An element and its neighbours at the time of the focus; they show where it was after it has gone. */
interface Position {
  readonly element: Element;
  readonly previous: Element | null;
  readonly next: Element | null;
}

interface Focused {
  readonly element: HTMLElement;
  /** Its name, to find the same control in content that was rendered again. */
  readonly name: string;
  /** The element and its ancestors, from the inside out. */
  readonly path: readonly Position[];
}

const nameOf = (element: Element): string => element.getAttribute("aria-label") ?? element.textContent;
const isShown = (element: Element): boolean => element.isConnected && (element.checkVisibility?.() ?? true);
const isEnabled = (element: Element): boolean => !element.matches(":disabled") && !element.closest("[inert]");
const isFocusable = (element: Element): element is HTMLElement =>
  element instanceof HTMLElement &&
  isShown(element) &&
  isEnabled(element) &&
  (element.tabIndex >= 0 || element.isContentEditable);
/** A part of the page may lose its Tab stop once it has controls of its own. */
const hasStop = (element: Element): boolean =>
  !(element instanceof HTMLElement) ||
  element.tabIndex >= 0 ||
  element.hasAttribute("tabindex") ||
  element.isContentEditable;
const isLost = (element: Element): boolean => !isShown(element) || !isEnabled(element) || !hasStop(element);

function remember(element: HTMLElement): Focused {
  const path: Position[] = [];
  for (let each: Element | null = element; each; each = each.parentElement)
    path.push({ element: each, previous: each.previousElementSibling, next: each.nextElementSibling });
  return { element, name: nameOf(element), path };
}

/** The element of a part of the page that gets the focus: the same control, the marked one, or the first one. */
function targetIn(part: Element | null, name: string): HTMLElement | null {
  if (!part || !isShown(part)) return null;
  const all = [...part.querySelectorAll(FOCUSABLE)];
  // Whether an element is shown is asked last: it costs a layout, and a table has thousands of fields.
  const first = (is: (each: Element) => boolean) =>
    all.find((each): each is HTMLElement => is(each) && isFocusable(each));
  const marked = part.querySelector(`[${FIRST_FOCUS}]`) ?? part.querySelector(MAIN);
  return (
    (name === "" ? undefined : first((each) => each.matches("button, a") && nameOf(each) === name)) ??
    (marked ? first((each) => marked.contains(each)) : undefined) ??
    first(() => true) ??
    null
  );
}

/** Where the focus goes instead of an element that was lost: what has taken its place, its neighbours, then around it. */
function placeOf({ name, path, element }: Focused): HTMLElement | null {
  if (!isLost(element)) return element;
  const outer = path.findIndex((each, i) => i > 0 && isShown(each.element));
  const [lost, around] = [path[outer - 1], path[outer]];
  if (!lost || !around) return null;
  const { previous, next } = lost;
  const after = previous?.isConnected ? previous.nextElementSibling : around.element.firstElementChild;
  for (const part of after === next ? [next, previous] : [after, next, previous]) {
    if (!part || !around.element.contains(part)) continue;
    const found = targetIn(part, name) ?? (isFocusable(part) ? part : null);
    if (found) return found;
  }
  for (const each of path.slice(outer)) {
    const found = targetIn(each.element, name);
    if (found) return found;
  }
  return null;
}

/** Whether an element was in a dialog that has closed. */
const wasInDialog = ({ path }: Focused): boolean =>
  path.some(({ element }) => element instanceof HTMLDialogElement && !(element.isConnected && element.open));

/** Frames in which components place the focus themselves, and in which a part of the page may appear. */
const OWN_FRAMES = 2;
const MOST_FRAMES = 120;

/** Whether the focus is being moved to a part of the page that is not shown yet. */
const moving = { isPending: false };

/** The element that has the focus only because another one was lost; null once the operator acts. */
const placed: { element: Element | null } = { element: null };

/** Whether the focus is where the operator has put it; otherwise a part that opens late may still take it. */
export const isFocusChosen = (): boolean => placed.element === null || placed.element !== document.activeElement;

/**
 * Moves the focus into a part of the page as soon as it is shown. `ask` lets the part place it on one of its elements;
 * otherwise it gets the first one. The next key or press has its way.
 */
export function focusPart(selector: string, ask: () => void): void {
  let isAsked = false;
  const user = new AbortController();
  const end = () => {
    moving.isPending = false;
    user.abort();
  };
  const look = (frame: number) => {
    if (user.signal.aborted) return;
    const part = document.querySelector(selector);
    const target = frame < OWN_FRAMES ? null : targetIn(part, "");
    if (part && part !== document.activeElement && part.contains(document.activeElement)) return end();
    if (target && isAsked) target.focus({ preventScroll: true });
    if ((target && isAsked) || frame === MOST_FRAMES) return end();
    if (target) {
      isAsked = true;
      ask();
    }
    requestAnimationFrame(() => look(frame + 1));
  };
  moving.isPending = true;
  // Not the event that has called this.
  requestAnimationFrame(() => {
    for (const act of ["keydown", "pointerdown"] as const)
      document.addEventListener(act, end, { capture: true, signal: user.signal });
    look(0);
  });
}

/** Gives the focus a new place when its element disappears, as long as the page is operated by keys or a mouse. */
export function guardFocus(): void {
  let past: readonly Focused[] = [];
  let byTouch = false;
  let pending = false;
  const isAway = (): boolean => {
    const [last] = past;
    const { activeElement: now, body } = document;
    if (!last) return false;
    return now === null || now === body ? isLost(last.element) : now === last.element && !isEnabled(now);
  };
  const settle = (frame: number) => {
    pending = false;
    if (byTouch || moving.isPending || !isAway()) return;
    // The page that replaces another one may have to be fetched first.
    if (frame < MOST_FRAMES && !document.querySelector(MAIN)) return wait(frame + 1);
    const behind = past.filter((each) => !wasInDialog(each));
    for (const each of behind) {
      const target = placeOf(each);
      if (!target || target === document.body) continue;
      placed.element = target;
      return target.focus({ preventScroll: true });
    }
  };
  const wait = (frame: number) => {
    pending = true;
    requestAnimationFrame(() => (frame < OWN_FRAMES ? wait(frame + 1) : settle(frame)));
  };
  const look = () => {
    if (!pending && !byTouch && isAway()) wait(0);
  };
  document.addEventListener("focusin", ({ target }) => {
    if (!(target instanceof HTMLElement) || target === document.body) return;
    past = [remember(target), ...past.filter(({ element }) => element !== target)].slice(0, MOST_REMEMBERED);
  });
  document.addEventListener("focusout", ({ target, relatedTarget }) => {
    // The focus was given up by a click beside every control.
    if (relatedTarget === null && target instanceof Element && !isLost(target) && document.hasFocus())
      queueMicrotask(() => {
        if (!isLost(target) && document.activeElement === document.body) past = [];
      });
  });
  const act = (isTouch: boolean) => {
    byTouch = isTouch;
    placed.element = null;
  };
  document.addEventListener("pointerdown", ({ pointerType }) => act(pointerType === "touch"), true);
  document.addEventListener("keydown", () => act(false), true);
  for (const act of ["keyup", "click"] as const) document.addEventListener(act, look);
  new MutationObserver(look).observe(document.body, {
    childList: true,
    subtree: true,
    attributes: true,
    attributeFilter: ["disabled", "hidden", "inert", "open", "tabindex"],
  });
}
