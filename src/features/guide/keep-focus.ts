/**
 * Before a press that may take its own button away: the focus stays in the part round it, so that keys go on working
 * there.
 */
export function keepFocus(button: HTMLElement, part: "section" | "main"): void {
  const round = button.closest<HTMLElement>(part);
  if (!round) return;
  round.tabIndex = -1;
  round.focus({ preventScroll: true });
}
