/**
 * Before a click that may remove its own button: focus moves to the surrounding part, so that keys keep working there.
 */
export function keepFocus(button: HTMLElement, part: "section" | "main"): void {
  const round = button.closest<HTMLElement>(part);
  if (!round) return;
  round.tabIndex = -1;
  round.focus({ preventScroll: true });
}
