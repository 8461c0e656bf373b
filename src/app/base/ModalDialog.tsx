import { useLayoutEffect, useRef, type ReactNode, type RefObject } from "react";
import { Icon } from "./Icon.tsx";
import { useTexts } from "./settings/use-texts.ts";
import "./modal.css";

interface Props {
  /** Undefined while its texts are being loaded. */
  readonly title: string | undefined;
  /** Visible heading, if it says more than the accessible name. */
  readonly heading?: string;
  readonly done: () => void;
  readonly className?: string;
  /** Selector of the element that gets the focus first; by default the marked one, or the first control of the content. */
  readonly first?: string;
  readonly role?: "alertdialog";
  /** Buttons beside the title. */
  readonly actions?: ReactNode;
  /** No title bar: the content has its own title and close button. */
  readonly isBare?: boolean;
  readonly ref?: RefObject<HTMLDialogElement | null>;
  readonly children: ReactNode;
}

const CONTROL = ":is(button, input, select, textarea, a[href], [tabindex='0']):not(:disabled, .modal-head *)";

/** Closing is never the first thing to do: without a marked element the first control of the content has the focus. */
function focusFirst(dialog: HTMLElement, first: string): void {
  const focused = document.activeElement;
  // Late texts must not take the focus from where the user has moved it.
  if (dialog.contains(focused) && focused !== dialog && !focused?.matches(".modal-head *")) return;
  (dialog.querySelector<HTMLElement>(first) ?? dialog.querySelector<HTMLElement>(CONTROL))?.focus();
}

/**
 * A modal dialog, open while it is mounted. It closes before it unmounts, so that the focus returns to where it was.
 * Escape and the close button close it; its key events do not reach the page, and a nested dialog closes alone.
 */
export function ModalDialog({
  title,
  heading = title,
  done,
  first = ".modal-first",
  actions,
  isBare = false,
  children,
  ...more
}: Props) {
  const { close } = useTexts("first").page;
  const own = useRef<HTMLDialogElement>(null);
  const { className = "modal", role, ref: dialog = own } = more;
  const isLoaded = title !== undefined;
  useLayoutEffect(() => {
    const { current } = dialog;
    current?.showModal();
    return () => current?.close();
  }, [dialog]);
  useLayoutEffect(() => {
    if (isLoaded && dialog.current) focusFirst(dialog.current, first);
  }, [dialog, first, isLoaded]);
  return (
    <dialog
      ref={dialog}
      className={className}
      role={role}
      aria-label={title}
      onClose={(event) => event.target === dialog.current && !dialog.current.open && done()}
      onKeyDown={(event) => event.stopPropagation()}
    >
      {!isBare && (
        <div className="modal-head">
          <h2>{heading}</h2>
          {actions}
          <button
            type="button"
            className="button icon plain"
            aria-label={close}
            onClick={() => dialog.current?.close()}
          >
            <Icon name="close" />
          </button>
        </div>
      )}
      {children}
    </dialog>
  );
}
