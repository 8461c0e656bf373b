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

/**
 * Closing is never the first thing to do: without a marked element the first control of the content gets the focus.
 * Content may come late, and then it must not take the focus from where the user has moved it.
 */
function focusFirst(dialog: HTMLElement, first: string): () => void {
  const given = document.activeElement;
  const watch = new MutationObserver(settle);
  function settle(): void {
    const to = dialog.querySelector<HTMLElement>(first) ?? dialog.querySelector<HTMLElement>(CONTROL);
    if (!to && document.activeElement === given) return;
    watch.disconnect();
    if (document.activeElement === given) to?.focus();
  }
  watch.observe(dialog, { childList: true, subtree: true });
  settle();
  return () => watch.disconnect();
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
    if (!current) return undefined;
    current.showModal();
    const unwatch = focusFirst(current, first);
    return () => {
      unwatch();
      current.close();
    };
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
