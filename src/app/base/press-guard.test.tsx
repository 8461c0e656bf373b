import { afterEach, beforeAll, beforeEach, expect, test } from "vitest";
import { guardPresses } from "./press-guard.ts";

/** Height of a row of the list, px. jsdom has no layout: a row is as far down as it comes in its list. */
const ROW = 32;
const pressed: string[] = [];

beforeAll(() => {
  guardPresses();
  HTMLElement.prototype.getBoundingClientRect = function box(this: HTMLElement) {
    const shift = Number(document.querySelector("ol")?.dataset["shift"] ?? 0);
    return new DOMRect(0, shift + ROW * [...document.querySelectorAll("button, summary")].indexOf(this), 100, ROW);
  };
});
beforeEach(() => {
  document.body.innerHTML = `<ol><li><button><b>one</b></button><li><button><b>two</b></button><li><button>three</button></ol><p>text</p>`;
  pressed.length = 0;
});
afterEach(() => {
  document.body.innerHTML = "";
});
document.addEventListener("click", ({ target }) => {
  if (target instanceof Element) pressed.push(target.closest("button")?.textContent ?? target.localName);
});

const row = (text: string): HTMLElement => {
  const found = [...document.querySelectorAll("button")].find((each) => each.textContent === text);
  if (!found) throw new Error(`no ${text}`);
  return found;
};
const mouse = (kind: string, on: Element, y = 10, more: object = {}) =>
  on.dispatchEvent(
    Object.assign(
      new MouseEvent(kind, { bubbles: true, cancelable: true, clientX: 5, clientY: y, detail: 1, ...more }),
      {
        isPrimary: true,
      },
    ),
  );
const list = (): HTMLElement => document.querySelector("ol") ?? document.body;
const shiftList = () => list().setAttribute("data-shift", "24");
const renderAgain = () => {
  list().innerHTML = list().innerHTML;
};

test.each<[string, { during?: () => void; on: () => Element; y?: number; button?: number; gives: readonly string[] }]>([
  ["a row that stands", { on: () => row("two"), gives: ["two"] }],
  ["a list that moved", { during: shiftList, on: list, gives: ["two"] }],
  ["a list that moved, released on the next row", { during: shiftList, on: () => row("one"), gives: ["two"] }],
  ["rows that were rendered again", { during: renderAgain, on: list, gives: ["two"] }],
  ["a row that is gone", { during: () => row("two").remove(), on: list, gives: ["ol"] }],
  [
    "two rows of its name after rendering",
    {
      during: () => void (list().innerHTML = "<li><button>two</button><li><button>two</button>"),
      on: list,
      gives: ["ol"],
    },
  ],
  ["a pointer that was moved away", { during: shiftList, on: list, y: 60, gives: ["ol"] }],
  ["a row that stands, released beside it", { on: list, gives: ["ol"] }],
  ["another button of the mouse", { during: shiftList, on: list, button: 2, gives: ["ol"] }],
])("a press on a row: %s", (_, { during, on, y = 10, button = 0, gives }) => {
  mouse("pointerdown", row("two").firstElementChild ?? row("two"), 10, { button });
  during?.();
  mouse("click", on(), y);
  expect(pressed).toEqual(gives);
});

test("a press is over with its click, and a click of the keyboard has none", () => {
  mouse("pointerdown", row("two"));
  mouse("click", row("two"));
  shiftList();
  mouse("click", list());
  mouse("pointerdown", row("three"));
  list().setAttribute("data-shift", "48");
  mouse("click", row("one"), 10, { detail: 0 });
  expect(pressed).toEqual(["two", "ol", "one"]);
});
