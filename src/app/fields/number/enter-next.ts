import type { KeyboardEvent } from "react";

/**
 * Enter in a field goes to the next one of the form, as ENT does on the control. `more`: selector of what else it stops
 * at. In the last field Enter keeps its own meaning.
 */
export const enterNext =
  (more?: string) =>
  (event: KeyboardEvent<HTMLElement>): void => {
    const from = event.target;
    if (event.key !== "Enter" || !(from instanceof HTMLInputElement) || from.dataset["enter"] === "own") return;
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
