import { useRef, useState } from "react";
import type { ExampleId } from "../../examples/index.ts";
import {
  canOpenFiles,
  ENDINGS,
  pickFiles,
  pickFolder,
  plainFiles,
  type Chosen,
} from "../../app/records/files/file-handle.ts";
import type * as FolderPart from "../../app/records/files/folder.ts";
import { retryImport } from "../../app/base/parts.ts";
import { openFiles, openFolder, openText, type OpenResult } from "../../app/fields/open/open-program.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { WhichButton } from "../../app/document/WhichButton.tsx";
import { CreateProgram } from "./CreateProgram.tsx";
import { PartPicture } from "../../app/fields/kept/PartPicture.tsx";
import type { StartPictures } from "./pictures.ts";

/** Opens one of the built-in example programs. */
export async function openExample(id: string): Promise<void> {
  const { examples } = await import("../../examples/index.ts");
  const found = examples.find((example) => example.id === id);
  if (found) openText(found.text);
}

/** Ways to get an NC program: a file, a paste, a new one, an example. */
export function ProgramStart({ pictures }: { readonly pictures: StartPictures | null }) {
  const t = useTexts("first").page;
  const [opening, setOpening] = useState<OpenResult>("opened");
  const [creating, create] = useState(false);
  const [pasted, paste] = useState(false);
  const area = useRef<HTMLTextAreaElement>(null);
  const file = useRef<HTMLInputElement>(null);
  const folder = useRef<HTMLInputElement>(null);
  const dialog = useRef<HTMLDialogElement>(null);

  const take = async (chosen: readonly Chosen[]) => setOpening(chosen.length > 0 ? await openFiles(chosen) : "opened");
  const ask = async () => {
    if (!canOpenFiles()) return file.current?.click();
    await take(await pickFiles());
  };
  const takeFolder = async (content: (part: typeof FolderPart) => Promise<FolderPart.FolderContent>) =>
    setOpening(await openFolder(await content(await retryImport(() => import("../../app/records/files/folder.ts")))));
  const askFolder = async () => {
    const picked = await pickFolder();
    if (picked === undefined) return folder.current?.click();
    if (picked) await takeFolder(({ filesOfFolder }) => filesOfFolder(picked));
  };

  return (
    <section className="program-start" aria-label={t.programs.title}>
      <h2>{t.programs.title}</h2>
      <p className="soft">{t.programs.lead}</p>
      <div className="program-ways">
        <button type="button" className="button primary" onClick={() => void ask()}>
          {t.programs.openFile}
        </button>
        <input
          ref={file}
          type="file"
          multiple
          hidden
          accept={[...ENDINGS, "text/plain", ".zip", ".json"].join(",")}
          onChange={(event) => void take(plainFiles(event.currentTarget.files))}
        />
        <button type="button" className="button" onClick={() => void askFolder()}>
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
        <button type="button" className="button" onClick={() => dialog.current?.showModal()}>
          {t.programs.paste}
        </button>
        <button type="button" className="button" onClick={() => create(true)}>
          {t.programs.create}
        </button>
        <WhichButton className="button" name={t.start.which} />
        <span className="soft small">{t.programs.drop}</span>
      </div>
      <p role="status" className="program-unreadable">
        {opening !== "opened" && (
          <>
            <Icon name="error" /> {t.programs[opening]}
          </>
        )}
      </p>
      <h3>{t.programs.examples}</h3>
      <ul className="program-examples">
        {Object.entries(t.examples as Readonly<Record<ExampleId, string>>).map(([id, title]) => (
          <li key={id}>
            <button
              type="button"
              className="button program-example"
              aria-label={t.programs.example(title)}
              onClick={() => void openExample(id)}
            >
              <PartPicture of={pictures?.examples[id as ExampleId]} />
              <span>{title}</span>
            </button>
          </li>
        ))}
      </ul>
      {creating && <CreateProgram done={() => create(false)} />}
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
    </section>
  );
}
