import { useLayoutEffect, type RefObject } from "react";

/**
 * Lets a dialog stand before the page for as long as it is there; `first` names what has the keyboard at first, where
 * that is not its first control. It closes before it goes, so that the keyboard returns to where it was.
 */
export function useModal(dialog: RefObject<HTMLDialogElement | null>, first: string | null = null): void {
  useLayoutEffect(() => {
    const { current } = dialog;
    current?.showModal();
    if (first !== null) current?.querySelector<HTMLElement>(first)?.focus();
    return () => current?.close();
  }, [dialog, first]);
}
