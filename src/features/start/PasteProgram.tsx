import { useEffect, useRef, useState } from "react";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { openText } from "../../app/fields/open/open-program.ts";

/** The dialog to paste a program. `asked` counts up to open it; its text stays when it is closed. */
export function PasteProgram({ asked }: { readonly asked: number }) {
  const t = useTexts("first").page.programs;
  const [pasted, paste] = useState(false);
  const area = useRef<HTMLTextAreaElement>(null);
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    if (!dialog.current?.open) dialog.current?.showModal();
  }, [asked]);
  return (
    <dialog ref={dialog} className="paste-program" aria-label={t.pasteTitle}>
      <h2>{t.pasteTitle}</h2>
      <textarea
        className="number"
        rows={14}
        spellCheck={false}
        aria-label={t.pasteLabel}
        ref={area}
        onChange={(event) => paste(event.currentTarget.value.trim() !== "")}
        onPaste={(event) => {
          // Set at once: pasting a long program into the field would take seconds.
          const text = event.clipboardData.getData("text/plain");
          if (event.currentTarget.value !== "" || text.trim() === "") return;
          event.preventDefault();
          event.currentTarget.value = text;
          paste(true);
        }}
      />
      <div className="program-ways">
        <button
          type="button"
          className="button primary"
          disabled={!pasted}
          onClick={() => {
            dialog.current?.close();
            openText(area.current?.value ?? "");
          }}
        >
          {t.pasteOpen}
        </button>
        <button type="button" className="button" onClick={() => dialog.current?.close()}>
          {t.cancel}
        </button>
      </div>
    </dialog>
  );
}
