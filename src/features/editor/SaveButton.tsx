import { useState } from "react";
import { type ShowBlock, showComparison } from "../../app/place/place.ts";
import { canSaveFiles } from "../../app/records/files/file-handle.ts";
import { shownFile } from "../../app/document/shown-file.ts";
import type { Obstacle } from "../../app/records/files/SaveProblem.tsx";
import type { SaveHow } from "../../app/records/files/save-back.ts";
import { lazyPart, retryImport } from "../../app/base/parts.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { useEditor } from "../../app/document/store.ts";
import { flushText } from "../../app/fields/blocks/session.ts";

/** Loaded when a file cannot be written at once. */
const SaveProblem = lazyPart(async () => ({
  default: (await import("../../app/records/files/SaveProblem.tsx")).SaveProblem,
}));

interface Props {
  /** Name of the shown file. */
  readonly name: string;
  /** Asks before a program with faults leaves; true if it may. */
  readonly mayLeave: () => Promise<boolean>;
  readonly onSaved: (name: string) => void;
  readonly onDownload: () => void;
  readonly showBlock: ShowBlock;
}

/** Saves the shown file back to its source. Reports an obstacle, with alternatives. */
export function SaveButton({ name, mayLeave, onSaved, onDownload, showBlock }: Props) {
  const t = useTexts().editor;
  const [obstacle, meet] = useState<Obstacle | null>(null);
  const write = async (how: SaveHow) => {
    flushText();
    const { program, work } = useEditor.getState();
    if (!program || work === null) return;
    const { saveBack } = await retryImport(() => import("../../app/records/files/save-back.ts"));
    const file = shownFile(program);
    const saved = await saveBack(work, file, how);
    if (saved.kind === "written") onSaved(file.name);
    if (saved.kind === "written" || saved.kind === "closed") meet(null);
    else meet(saved);
  };
  const save = async () => {
    if (await mayLeave()) await write("careful");
  };
  const compare = async (bytes: Uint8Array<ArrayBuffer>) => {
    const { decodeAny } = await import("../../app/document/encoding.ts");
    showComparison(showBlock, { name, text: decodeAny(bytes).text });
  };
  if (!canSaveFiles() && !obstacle) return null;
  return (
    <>
      <button type="button" className="button" aria-label={t.saveLong(name)} onClick={() => void save()}>
        {t.save}
      </button>
      {obstacle && (
        <SaveProblem
          file={name}
          obstacle={obstacle}
          canSave={canSaveFiles()}
          onSave={(how) => void write(how)}
          onDownload={onDownload}
          onCompare={(bytes) => void compare(bytes)}
          done={() => meet(null)}
        />
      )}
    </>
  );
}
