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
  /** Selector of the element that gets the focus first; by default the marked one. */
  readonly first?: string;
  readonly role?: "alertdialog";
  /** Buttons beside the title. */
  readonly actions?: ReactNode;
  /** No title bar: the content has its own title and close button. */
  readonly isBare?: boolean;
  readonly ref?: RefObject<HTMLDialogElement | null>;
  readonly children: ReactNode;
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
  useLayoutEffect(() => {
    const { current } = dialog;
    current?.showModal();
    current?.querySelector<HTMLElement>(first)?.focus();
    return () => current?.close();
  }, [dialog, first]);
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
