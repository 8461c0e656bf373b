import { useRef, useState } from "react";
import {
  canOpenFiles,
  OPENED,
  pickFiles,
  pickFolder,
  plainFiles,
  type Chosen,
} from "../../app/records/files/file-handle.ts";
import type * as FolderPart from "../../app/records/files/folder.ts";
import { retryImport } from "../../app/base/parts.ts";
import type { OpenResult } from "../../app/fields/open/open-files.ts";
import { fetchOpenFiles, openText } from "../../app/fields/open/open-program.ts";
import { Door } from "./Door.tsx";
import { Icon } from "../../app/base/Icon.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** The door to an NC program: a file, a folder, a paste. */
export function OpenDoor() {
  const {
    page: t,
    start: { doors },
  } = useTexts("first");
  const [opening, setOpening] = useState<OpenResult>("opened");
  const [pasted, paste] = useState(false);
  const area = useRef<HTMLTextAreaElement>(null);
  const file = useRef<HTMLInputElement>(null);
  const folder = useRef<HTMLInputElement>(null);
  const dialog = useRef<HTMLDialogElement>(null);

  const take = async (chosen: readonly Chosen[]) =>
    setOpening(chosen.length > 0 ? await (await fetchOpenFiles()).openFiles(chosen) : "opened");
  const ask = async () => {
    if (!canOpenFiles()) return file.current?.click();
    await take(await pickFiles());
  };
  const takeFolder = async (content: (part: typeof FolderPart) => Promise<FolderPart.FolderContent>) => {
    const [part, { openFolder }] = await Promise.all([
      retryImport(() => import("../../app/records/files/folder.ts")),
      fetchOpenFiles(),
    ]);
    setOpening(await openFolder(await content(part)));
  };
  const askFolder = async () => {
    const picked = await pickFolder();
    if (picked === undefined) return folder.current?.click();
    if (picked) await takeFolder(({ filesOfFolder }) => filesOfFolder(picked));
  };

  return (
    <Door name={t.programs.openFile} how={doors.openHow} go={() => void ask()}>
      <input
        ref={file}
        type="file"
        multiple
        hidden
        accept={OPENED.join(",")}
        onChange={(event) => void take(plainFiles(event.currentTarget.files))}
      />
      <button type="button" className="door-way" onClick={() => void askFolder()}>
        {t.programs.openFolder}
      </button>
      <input
        ref={folder}
        type="file"
        multiple
        hidden
        {...{ webkitdirectory: "" }}
        onChange={(event) => {
          const list = [...(event.currentTarget.files ?? [])];
          if (list.length > 0) void takeFolder(({ filesOfList }) => filesOfList(list));
        }}
      />
      <button type="button" className="door-way" onClick={() => dialog.current?.showModal()}>
        {t.programs.paste}
      </button>
      <span className="soft small">{t.programs.drop}</span>
      <p role="status" className="program-unreadable">
        {opening !== "opened" && (
          <>
            <Icon name="error" /> {t.programs[opening]}
          </>
        )}
      </p>
      <dialog ref={dialog} className="paste-program" aria-label={t.programs.pasteTitle}>
        <h2>{t.programs.pasteTitle}</h2>
        <textarea
          className="number"
          rows={14}
          spellCheck={false}
          aria-label={t.programs.pasteLabel}
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
            {t.programs.pasteOpen}
          </button>
          <button type="button" className="button" onClick={() => dialog.current?.close()}>
            {t.programs.cancel}
          </button>
        </div>
      </dialog>
    </Door>
  );
}
