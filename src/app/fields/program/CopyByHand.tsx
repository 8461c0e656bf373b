import { useLayoutEffect, useRef } from "react";
import { useTexts } from "../../base/settings/use-texts.ts";
import { closeCopying, useCopying } from "../../findings/copy.ts";

/** Shown when the clipboard is refused: the selected text, to copy by hand. */
export function CopyByHand() {
  const t = useTexts("first").page;
  const text = useCopying((c) => c.text);
  const dialog = useRef<HTMLDialogElement>(null);
  const area = useRef<HTMLTextAreaElement>(null);

  useLayoutEffect(() => {
    dialog.current?.showModal();
    area.current?.focus();
    area.current?.select();
  }, []);

  return (
    <dialog ref={dialog} className="copy-by-hand" aria-label={t.text.refusedTitle} onClose={closeCopying}>
      <h2>{t.text.refusedTitle}</h2>
      <p>{t.text.refused}</p>
      <textarea ref={area} className="number" readOnly rows={16} value={text} aria-label={t.text.title} />
      <button type="button" className="button primary" onClick={() => dialog.current?.close()}>
        {t.close}
      </button>
    </dialog>
  );
}
