import { useRef } from "react";
import { filesOf, type ProgramWork } from "../../app/document/work.ts";
import { closeProgramChoice, type ProgramChoice } from "../../app/document/program-choice.ts";
import { useTextsOrNull } from "../../app/base/settings/use-texts.ts";
import { ModalDialog } from "../../app/base/ModalDialog.tsx";

/** Asks which of several programs to open. Closing it opens none. */
export function ChooseProgram({ works, skipped, isCut, open, together }: ProgramChoice) {
  const t = useTextsOrNull("files");
  const dialog = useRef<HTMLDialogElement>(null);
  const take = (chosen: readonly ProgramWork[]) => () => {
    dialog.current?.close();
    open(chosen);
  };
  const words = t?.choose;
  return (
    <ModalDialog isBare ref={dialog} className="choose-program" title={words?.title} done={closeProgramChoice}>
      {t && words && (
        <>
          <h2>{words.title}</h2>
          <p>{words.lead(works.length)}</p>
          <ul className="choose-list">
            {works.map((work) => (
              <li key={work.name}>
                <button type="button" className="button" aria-label={words.open(work.name)} onClick={take([work])}>
                  <span className="file-name number">{work.name}</span>
                  <span className="soft small">
                    {filesOf(work).length > 0 ? words.with(filesOf(work).length) : words.alone}
                  </span>
                </button>
              </li>
            ))}
          </ul>
          {skipped > 0 && <p className="soft small">{words.skipped(skipped)}</p>}
          {isCut && <p className="soft small">{words.cut}</p>}
          <div className="program-ways">
            <button type="button" className="button primary" onClick={take(works)}>
              {words.all(works.length)}
            </button>
            <button
              type="button"
              className="button"
              onClick={() => {
                dialog.current?.close();
                together();
              }}
            >
              {words.together}
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
