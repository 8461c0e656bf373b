import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { declareActions, isPressed, keysOf, onActionKey, possibleActions, type Action } from "./actions.ts";

const pressed = (key: string, modifiers: Partial<KeyboardEventInit> = {}) =>
  new KeyboardEvent("keydown", { key, ...modifiers });

describe("a combination is pressed", () => {
  test.each([
    ["Ctrl Z", "z", { ctrlKey: true }, true],
    ["Ctrl Z", "Z", { metaKey: true }, true],
    ["Ctrl Z", "Z", { ctrlKey: true, shiftKey: true }, false],
    ["Ctrl Z", "z", { ctrlKey: true, altKey: true }, false],
    ["Ctrl Z", "z", {}, false],
    ["Ctrl Shift Z", "Z", { ctrlKey: true, shiftKey: true }, true],
    ["F3", "F3", {}, true],
    ["F3", "F3", { shiftKey: true }, false],
    ["Shift F3", "F3", { shiftKey: true }, true],
    // A sign needs Shift on some keyboards and not on others.
    ["?", "?", { shiftKey: true }, true],
    ["?", "?", {}, true],
    ["?", "?", { ctrlKey: true }, false],
  ] as const)("%s by %s %o: %s", (combination, key, modifiers, expected) =>
    expect(isPressed(combination, pressed(key, modifiers))).toBe(expected),
  );
});

describe("declared actions", () => {
  const [outer, inner, keys] = [vi.fn(), vi.fn(), vi.fn()];
  let undeclare: readonly (() => void)[] = [];
  const declare = (...actions: readonly Action[]) => {
    undeclare = [...undeclare, declareActions(() => actions)];
  };
  const press = (at: Element, key: string, modifiers: Partial<KeyboardEventInit> = {}) =>
    at.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true, ...modifiers }));
  beforeEach(() => {
    document.addEventListener("keydown", onActionKey);
    document.body.innerHTML = "<input><dialog><button></button></dialog>";
    declare({ id: "text.next", run: outer }, { id: "everywhere.keys", run: keys });
  });
  afterEach(() => {
    document.removeEventListener("keydown", onActionKey);
    for (const end of undeclare) end();
    undeclare = [];
    vi.resetAllMocks();
  });
  const element = (selector: string) => document.querySelector(selector) ?? document.body;

  test("run by their shortcut, the last declared one of an id alone", () => {
    press(document.body, "F3");
    declare({ id: "text.next", run: inner });
    press(element("input"), "F3");
    expect([outer.mock.calls.length, inner.mock.calls.length]).toEqual([1, 1]);
    expect(possibleActions().map(({ id }) => id)).toEqual(["text.next", "everywhere.keys"]);
  });

  test("a sign typed into a field is text, and a dialog keeps its keys", () => {
    press(element("input"), "?");
    press(element("dialog button"), "?");
    press(element("dialog button"), "F3");
    expect([outer.mock.calls.length, keys.mock.calls.length]).toEqual([0, 0]);
    expect(press(document.body, "?")).toBe(false);
    expect(keys).toHaveBeenCalledOnce();
  });

  test("a key that somebody else has taken is left alone", () => {
    const take = (event: Event) => event.preventDefault();
    document.body.addEventListener("keydown", take);
    press(document.body, "F3");
    document.body.removeEventListener("keydown", take);
    expect(outer).not.toHaveBeenCalled();
  });
});

test("an action without an entry in the list has no shortcut", () => {
  expect(keysOf("text.find")).toEqual(["Ctrl F"]);
  expect(keysOf("do.settings")).toEqual([]);
});
