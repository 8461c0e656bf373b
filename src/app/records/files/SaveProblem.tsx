import { useRef } from "react";
import { Icon } from "../../base/Icon.tsx";
import type { SaveBack, SaveHow } from "./save-back.ts";
import { useTextsOrNull } from "../../base/settings/use-texts.ts";
import { ModalDialog } from "../../base/ModalDialog.tsx";

/** Why saving failed. */
export type Obstacle = Exclude<SaveBack, { readonly kind: "written" | "closed" }>;

interface Props {
  readonly file: string;
  readonly obstacle: Obstacle;
  readonly canSave: boolean;
  readonly onSave: (how: SaveHow) => void;
  readonly onDownload: () => void;
  /** Compares with what the file holds now. */
  readonly onCompare: (bytes: Uint8Array<ArrayBuffer>) => void;
  readonly done: () => void;
}

/** Says why a file was not written, and offers what can be done. Closing it changes nothing. */
export function SaveProblem({ file, obstacle, canSave, onSave, onDownload, onCompare, done }: Props) {
  const t = useTextsOrNull("files");
  const dialog = useRef<HTMLDialogElement>(null);
  const leave = (way: () => void) => () => {
    dialog.current?.close();
    way();
  };
  const title = t?.[obstacle.kind].title(file);
  return (
    <ModalDialog isBare ref={dialog} className="save-problem" role="alertdialog" title={title} done={done}>
      {t && (
        <>
          <h2>
            <Icon name="warning" /> {title}
          </h2>
          <p>{t[obstacle.kind].text}</p>
          <div className="program-ways">
            {obstacle.kind === "changed" && (
              <>
                <button type="button" className="button primary" onClick={leave(() => onCompare(obstacle.bytes))}>
                  {t.compare}
                </button>
                <button type="button" className="button danger" onClick={leave(() => onSave("overwrite"))}>
                  {t.overwrite}
                </button>
              </>
            )}
            {canSave && (
              <button type="button" className="button" onClick={leave(() => onSave("elsewhere"))}>
                {t.elsewhere}
              </button>
            )}
            <button type="button" className="button" onClick={leave(onDownload)}>
              {t.download}
            </button>
            <button type="button" className="button" onClick={() => dialog.current?.close()}>
              {t.cancel}
            </button>
          </div>
        </>
      )}
    </ModalDialog>
  );
}
