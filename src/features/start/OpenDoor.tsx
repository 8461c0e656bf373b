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
import { lazyPart, retryImport } from "../../app/base/parts.ts";
import type { OpenResult } from "../../app/fields/open/open-files.ts";
import { fetchOpenFiles } from "../../app/fields/open/open-program.ts";
import { Door } from "./Door.tsx";
import { Icon } from "../../app/base/Icon.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";

const PasteProgram = lazyPart(async () => ({ default: (await import("./PasteProgram.tsx")).PasteProgram }));

/** The door to an NC program: a file, a folder, a paste. */
export function OpenDoor() {
  const {
    page: t,
    start: { doors },
  } = useTexts("first");
  const [opening, setOpening] = useState<OpenResult>("opened");
  const [pasting, paste] = useState(0);
  const file = useRef<HTMLInputElement>(null);
  const folder = useRef<HTMLInputElement>(null);

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
      <button type="button" className="door-way" onClick={() => paste(pasting + 1)}>
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
      {pasting > 0 && <PasteProgram asked={pasting} />}
    </Door>
  );
}
