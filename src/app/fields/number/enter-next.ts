import type { KeyboardEvent } from "react";

/**
 * Enter in a field or a closed list goes to the next one of the form, as ENT does on the control; in the last one it
 * keeps its own meaning. `more`: selector of what else it stops at.
 */
export const enterNext =
  (more?: string) =>
  (event: KeyboardEvent<HTMLElement>): void => {
    const from = event.target;
    if (event.key !== "Enter" || !(from instanceof HTMLInputElement || from instanceof HTMLSelectElement)) return;
    if (from.dataset["enter"] === "own") return;
    const stops = ["input", "select", ...(more === undefined ? [] : [more])].join();
    const fields = [
      ...event.currentTarget.querySelectorAll<HTMLInputElement | HTMLSelectElement | HTMLButtonElement>(stops),
    ].filter((f) => !f.disabled && f.tabIndex >= 0);
    const next = fields[fields.indexOf(from) + 1];
    if (!next) return;
    event.preventDefault();
    event.stopPropagation();
    next.focus();
    if (next instanceof HTMLInputElement && next.type === "text") next.select();
  };
