import { useLayoutEffect, useRef, type ReactNode, type RefObject } from "react";
import { Icon } from "./Icon.tsx";
import { useTexts } from "./settings/use-texts.ts";
import "./modal.css";

interface Props {
  /** Undefined while its texts are on their way. */
  readonly title: string | undefined;
  /** What stands above, where the name of the dialog says less. */
  readonly heading?: string;
  readonly done: () => void;
  readonly className?: string;
  /** What has the keyboard at first, where that is not the first control. */
  readonly first?: string;
  readonly role?: "alertdialog";
  /** What stands beside the title. */
  readonly actions?: ReactNode;
  /** Without a bar of its own for title and way out: the content has them. */
  readonly isBare?: boolean;
  readonly ref?: RefObject<HTMLDialogElement | null>;
  readonly children: ReactNode;
}

/**
 * A dialog before the page, open as long as it is there. It closes before it goes, so that the keyboard returns to
 * where it was. Escape and the way out close it; its keys are its own, and a dialog in it closes for itself.
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
