/*
 * A press acts on what was pressed. Between press and release a part of the page may arrive or a result may be shown:
 * the control moves away under the resting pointer, or is rendered again, and the browser sends the click to whatever
 * contains both places. Here it goes to the control where the press began.
 */

const CONTROL = "button, a[href], summary, label, [role=option], [role=tab], [role^=menuitem]";
/** Travel up to which a pointer rests, px. */
const RESTING = 8;

interface Press {
  readonly control: HTMLElement;
  readonly name: string;
  /** Its ancestors from the inside out: in the innermost one that is still shown, the same control is looked for. */
  readonly around: readonly Element[];
  readonly box: DOMRect;
  readonly x: number;
  readonly y: number;
}

const nameOf = (element: Element): string => element.getAttribute("aria-label") ?? element.textContent;

function ancestorsOf(element: Element): readonly Element[] {
  const all: Element[] = [];
  for (let each = element.parentElement; each; each = each.parentElement) all.push(each);
  return all;
}

/** The pressed control if it has moved, or the one that was rendered in its place; null where it still stands. */
function movedControl({ control, name, around, box }: Press): HTMLElement | null {
  if (control.isConnected && (control.checkVisibility?.() ?? true)) {
    const now = control.getBoundingClientRect();
    return now.x === box.x && now.y === box.y ? null : control;
  }
  const left = around.find((each) => each.isConnected && (each.checkVisibility?.() ?? true));
  const same = [...(left?.querySelectorAll<HTMLElement>(control.localName) ?? [])].filter((e) => nameOf(e) === name);
  return same.length === 1 ? (same[0] ?? null) : null;
}

/** Sends each click to the control where its press began, unless the pointer was moved away from it. */
export function guardPresses(): void {
  let press: Press | null = null;
  document.addEventListener(
    "pointerdown",
    ({ target, isPrimary, button, clientX: x, clientY: y }) => {
      const control =
        target instanceof Element && isPrimary && button === 0 ? target.closest<HTMLElement>(CONTROL) : null;
      press = control && {
        control,
        name: nameOf(control),
        around: ancestorsOf(control),
        box: control.getBoundingClientRect(),
        x,
        y,
      };
    },
    true,
  );
  document.addEventListener(
    "click",
    (event) => {
      const begun = press;
      press = null;
      // A click of the keyboard or of a script has no press.
      if (!begun || event.detail === 0 || !(event.target instanceof Node) || begun.control.contains(event.target))
        return;
      if (Math.hypot(event.clientX - begun.x, event.clientY - begun.y) > RESTING) return;
      const meant = movedControl(begun);
      if (!meant || meant.contains(event.target)) return;
      event.stopImmediatePropagation();
      event.preventDefault();
      meant.click();
    },
    true,
  );
}
