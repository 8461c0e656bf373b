import type { KeyboardEvent } from "react";

/**
 * Enter in a field or a closed list goes to the next one of the form, as ENT does on the control; in the last one it
 * goes to what comes after the form, or keeps its own meaning. `more`: selector of what else it stops at. `after`: what
 * comes after the form of a field.
 */
export const enterNext =
  (more?: string, after?: (from: HTMLElement) => HTMLElement | null | undefined) =>
  (event: KeyboardEvent<HTMLElement>): void => {
    const from = event.target;
    if (event.key !== "Enter" || !(from instanceof HTMLInputElement || from instanceof HTMLSelectElement)) return;
    if (from.dataset["enter"] === "own") return;
    const stops = ["input", "select", ...(more === undefined ? [] : [more])].join();
    const fields = [
      ...event.currentTarget.querySelectorAll<HTMLInputElement | HTMLSelectElement | HTMLButtonElement>(stops),
    ].filter((f) => !f.disabled && f.tabIndex >= 0);
    const next = fields[fields.indexOf(from) + 1] ?? after?.(from);
    if (!next) return;
    event.preventDefault();
    event.stopPropagation();
    next.focus();
    if (next instanceof HTMLInputElement && next.type === "text") next.select();
  };
