import { useRef, type ReactNode } from "react";
import { Icon } from "./Icon.tsx";
import { useTexts } from "./settings/use-texts.ts";
import { useModal } from "./use-modal.ts";
import "./handing.css";

/** A dialog over the page, open as long as it is there. */
export function HandingDialog({
  title,
  done,
  children,
}: {
  readonly title: string;
  readonly done: () => void;
  readonly children: ReactNode;
}) {
  const { close } = useTexts("first").page;
  const dialog = useRef<HTMLDialogElement>(null);
  useModal(dialog, ".handing-first");
  return (
    <dialog
      ref={dialog}
      className="handing"
      aria-label={title}
      onClose={() => !dialog.current?.open && done()}
      onKeyDown={(event) => event.stopPropagation()}
    >
      <div className="handing-head">
        <h2>{title}</h2>
        <button type="button" className="button icon plain" aria-label={close} onClick={() => dialog.current?.close()}>
          <Icon name="close" />
        </button>
      </div>
      {children}
    </dialog>
  );
}
