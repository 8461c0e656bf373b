import type { KeyboardEvent } from "react";
import { cancel, finish, noEntry, openCycle, step } from "./prompts.ts";
import { usePlace } from "../place.ts";

/** Elements that the Tab key visits inside the open prompt, in order. */
const stops = (root: Element): readonly HTMLElement[] =>
  [...root.querySelectorAll<HTMLElement>("input, button")].filter(
    (each) => each.tabIndex >= 0 && !each.hasAttribute("disabled") && (!(each instanceof HTMLInputElement) || each.type !== "radio" || each.checked || !anyChecked(root)),
  );

const anyChecked = (root: Element) => root.querySelector("input[type=radio]:checked") !== null;

/** Tab goes through the parts of the open prompt, then to the next prompt; backwards likewise. True when it was used. */
function tab(event: KeyboardEvent<HTMLElement>): boolean {
  const list = stops(event.currentTarget);
  const edge = event.shiftKey ? list[0] : list.at(-1);
  if (edge !== document.activeElement && list.length > 0) return false;
  const cycle = openCycle();
  const all = cycle ? Object.keys(cycle.params) : [];
  const at = all.indexOf(usePlace.getState().prompt ?? "");
  const next = at + (event.shiftKey ? -1 : 1);
  if (at < 0 || next < 0 || next >= all.length) return false;
  step(event.shiftKey ? -1 : 1);
  return true;
}

/** Keys of the control on a keyboard. What is not one of them is left to the field. */
export function onPromptKey(event: KeyboardEvent<HTMLElement>): void {
  if (event.ctrlKey || event.metaKey || event.altKey || event.nativeEvent.isComposing) return;
  const onButton = event.target instanceof HTMLButtonElement;
  const optional = () => {
    const { prompt } = usePlace.getState();
    return prompt !== null && (openCycle()?.params[prompt]?.optional ?? false);
  };
  let used = true;
  switch (event.key) {
    case "Enter":
      if (onButton) used = false;
      else step(1);
      break;
    case "ArrowDown": step(1); break;
    case "ArrowUp": step(-1); break;
    case "Tab": used = tab(event); break;
    case "End": finish(); break;
    case "Escape": cancel(); break;
    case "Delete":
      if (optional()) noEntry();
      else used = false;
      break;
    default: used = false;
  }
  if (used) {
    event.preventDefault();
    event.stopPropagation();
  }
}
