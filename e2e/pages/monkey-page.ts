import type { Page } from "@playwright/test";

/** A control to press: its middle on the screen, px. */
export interface Target {
  readonly x: number;
  readonly y: number;
  /** Role and name, to read. */
  readonly what: string;
  /** Role and name without numbers: the controls of a table are of one kind. */
  readonly kind: string;
  readonly isField: boolean;
  readonly isFocusable: boolean;
  /** Values of a list box. */
  readonly options: readonly string[];
}

interface Wish {
  readonly isTyping: boolean;
  readonly rolls: readonly [number, number];
  /** How often each kind was pressed. */
  readonly pressed: Readonly<Record<string, number>>;
}

/**
 * A visible control that can be hit, marked with `data-monkey`; null if there is none. Every second time it is one of
 * the kinds that were pressed least.
 */
export function takeTarget(page: Page, wish: Wish): Promise<Target | null> {
  return page.evaluate(({ isTyping, rolls, pressed }) => {
    const FIELDS = "input:not([type=checkbox],[type=radio],[type=range],[type=file]), textarea, [contenteditable=true]";
    const PRESSED =
      "button, a[href], input:not([type=file]), select, textarea, summary, [contenteditable=true], canvas, svg[tabindex]," +
      "[role=tab], [role=menuitem], [role=option], [role=radio], [role=switch], [role=checkbox], [role=slider], [tabindex='0']";
    document.querySelector("[data-monkey]")?.removeAttribute("data-monkey");
    const shown = [...document.querySelectorAll<HTMLElement>(isTyping ? FIELDS : PRESSED)].filter(
      (each) =>
        each.checkVisibility({ visibilityProperty: true, opacityProperty: true }) &&
        !each.matches(":disabled, [aria-disabled=true]") &&
        !each.closest("[inert], [aria-hidden=true]") &&
        // A link to another page would only leave.
        (!(each instanceof HTMLAnchorElement) || each.getAttribute("href")?.startsWith("#")),
    );
    const named = (each: HTMLElement) =>
      (
        each.getAttribute("aria-label") ??
        (each instanceof HTMLInputElement
          ? [...(each.labels ?? [])].map((l) => l.textContent).join(" ")
          : each.textContent)
      )
        .replace(/\s+/g, " ")
        .trim()
        .slice(0, 50);
    const kindOf = (each: HTMLElement) =>
      `${each.getAttribute("role") ?? each.tagName.toLowerCase()} ${named(each).replace(/[\d.,]+/g, "#")}`;
    const all = shown.map((each) => ({ each, kind: kindOf(each) }));
    const least = Math.min(...all.map(({ kind }) => pressed[kind] ?? 0));
    let among = rolls[0] < 0.5 ? all.filter(({ kind }) => (pressed[kind] ?? 0) === least) : all;
    for (let tries = 0; tries < 12 && among.length > 0; tries += 1) {
      const at = Math.floor(((rolls[1] * 997 * (tries + 1)) % 1) * among.length);
      const { each, kind } = among[at] as (typeof all)[number];
      among = among.toSpliced(at, 1);
      if (among.length === 0 && all.length > 1) among = all.filter((one) => one.each !== each);
      each.scrollIntoView({ block: "nearest", inline: "nearest", behavior: "instant" });
      const { left, top, width, height } = each.getBoundingClientRect();
      const [x, y] = [left + width / 2, top + Math.min(height / 2, 300)];
      const hit = document.elementFromPoint(x, y);
      const isHit =
        hit &&
        (each.contains(hit) ||
          (each instanceof HTMLInputElement && [...(each.labels ?? [])].some((l) => l.contains(hit))));
      if (!isHit) continue;
      each.setAttribute("data-monkey", "");
      return {
        x,
        y,
        kind,
        what: `${each.getAttribute("role") ?? each.tagName.toLowerCase()} "${named(each)}" at ${location.hash}`,
        isField: each.matches(FIELDS),
        isFocusable: each.tabIndex >= 0,
        options:
          each instanceof HTMLSelectElement ? [...each.options].filter((o) => !o.disabled).map((o) => o.value) : [],
      };
    }
    return null;
  }, wish);
}

/** Waits until the page is idle and, if asked, until some element has the focus; returns what has it, or "body". */
export function settle(page: Page, isFocusExpected: boolean): Promise<string> {
  return page.evaluate(
    (expected) =>
      new Promise<string>((done) => {
        const focused = () => {
          const now = document.activeElement;
          if (!now || now === document.body) return "body";
          const name = now.getAttribute("aria-label") ?? now.textContent.replace(/\s+/g, " ").trim();
          return `${now.getAttribute("role") ?? now.tagName.toLowerCase()} "${name.slice(0, 50)}"`;
        };
        // A part of the page may have to be fetched before it takes the focus.
        const look = (frame: number) => {
          if (frame >= 2 && (!expected || frame > 300 || focused() !== "body"))
            return requestIdleCallback(() => done(focused()), { timeout: 300 });
          requestAnimationFrame(() => look(frame + 1));
        };
        look(0);
      }),
    isFocusExpected,
  );
}

/** What is wrong with the page as it is shown: it has crashed, or its main part stays empty. */
export function shownFaults(page: Page): Promise<readonly string[]> {
  return page.evaluate(
    () =>
      new Promise<readonly string[]>((done) => {
        const look = (frame: number) => {
          if (document.querySelector("main.crash")) return done([`crashed at ${location.hash}`]);
          // An exercise that begins with a question hides the workplace.
          const parts = document.querySelectorAll<HTMLElement>("main, dialog[open], section");
          const isThere = [...parts].some((part) => part.innerText.trim() !== "");
          if (isThere) return done([]);
          if (frame > 900) return done([`empty screen at ${location.hash}: ${document.body.innerHTML.slice(0, 600)}`]);
          requestAnimationFrame(() => look(frame + 1));
        };
        look(0);
      }),
  );
}
