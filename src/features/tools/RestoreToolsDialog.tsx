import { shippedList } from "../../program/tools/tool-list.ts";
import { ModalDialog } from "../../app/base/ModalDialog.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { useTools } from "../../app/document/tool-store.ts";

/** Asks before the default tools replace the table. */
export function RestoreToolsDialog({ restore, done }: { readonly restore: () => void; readonly done: () => void }) {
  const t = useTexts("tables").tools;
  const mine = useTools((s) => s.list.length);
  return (
    <ModalDialog
      isBare
      role="alertdialog"
      className="tool-dialog"
      first=".button.plain"
      title={t.restoreLong}
      done={done}
    >
      <h2>{t.restoreLong}</h2>
      <p className="tool-dialog-body">{t.restoreAsk(mine, shippedList.length)}</p>
      <div className="tool-dialog-ways">
        <button type="button" className="button primary" onClick={restore}>
          {t.restoreNow}
        </button>
        <button type="button" className="button plain" onClick={done}>
          {t.cancel}
        </button>
      </div>
    </ModalDialog>
  );
}
