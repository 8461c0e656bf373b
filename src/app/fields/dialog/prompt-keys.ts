import type { KeyboardEvent } from "react";
import { commandsOf, openPromptOf, type PromptSession } from "./session.ts";

/** Elements that the Tab key visits inside the open prompt, in order. */
const stops = (root: Element): readonly HTMLElement[] =>
  [...root.querySelectorAll<HTMLElement>("input, button")].filter(
    (each) =>
      each.tabIndex >= 0 &&
      !each.hasAttribute("disabled") &&
      (!(each instanceof HTMLInputElement) || each.type !== "radio" || each.checked || !anyChecked(root)),
  );

const anyChecked = (root: Element) => root.querySelector("input[type=radio]:checked") !== null;

/** Tab goes through the parts of the open prompt, then to the next prompt; backwards likewise. */
export function onPromptTab(event: KeyboardEvent<HTMLElement>, session: PromptSession): void {
  if (event.key !== "Tab" || event.ctrlKey || event.metaKey || event.altKey || event.nativeEvent.isComposing) return;
  const list = stops(event.currentTarget);
  const edge = event.shiftKey ? list[0] : list.at(-1);
  if (edge !== document.activeElement && list.length > 0) return;
  const by = event.shiftKey ? -1 : 1;
  const open = openPromptOf(session);
  const next = open ? session.fields.indexOf(open) + by : -1;
  if (next < 0 || next >= session.fields.length) return;
  commandsOf(session).step(by);
  event.preventDefault();
  event.stopPropagation();
}

/** Keys of the control on a keyboard. All other keys are left to the field. */
export function onPromptKey(event: KeyboardEvent<HTMLElement>, session: PromptSession): void {
  if (event.ctrlKey || event.metaKey || event.altKey || event.nativeEvent.isComposing) return;
  const { enter, step, finish, cancel, noEntry } = commandsOf(session);
  const open = openPromptOf(session);
  const onButton = event.target instanceof HTMLButtonElement;
  const keys: Readonly<Record<string, (() => void) | null>> = {
    Enter: onButton ? null : enter,
    ArrowDown: () => step(1),
    ArrowUp: () => step(-1),
    End: finish,
    Escape: cancel,
    Delete: open?.optional || open?.idle ? noEntry : null,
  };
  const act = keys[event.key];
  if (!act) return;
  act();
  event.preventDefault();
  event.stopPropagation();
}
