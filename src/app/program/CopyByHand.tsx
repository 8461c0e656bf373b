import { useEffect, useRef } from "react";
import { useTexts } from "../settings/use-texts.ts";
import { closeCopying, useCopying } from "./copy.ts";

/** Where the clipboard is refused: the text, selected, to be copied by hand. */
export function CopyByHand() {
  const t = useTexts().page;
  const { state, text } = useCopying();
  const dialog = useRef<HTMLDialogElement>(null);
  const area = useRef<HTMLTextAreaElement>(null);

  useEffect(() => {
    if (state !== "refused") {
      dialog.current?.close();
      return;
    }
    dialog.current?.showModal();
    area.current?.focus();
    area.current?.select();
  }, [state]);

  return (
    <dialog ref={dialog} className="copy-by-hand" aria-label={t.text.refusedTitle} onClose={() => state === "refused" && closeCopying()}>
      <h2>{t.text.refusedTitle}</h2>
      <p>{t.text.refused}</p>
      <textarea ref={area} className="number" readOnly rows={16} value={text} aria-label={t.text.title} />
      <button type="button" className="button primary" onClick={closeCopying}>{t.close}</button>
    </dialog>
  );
}
