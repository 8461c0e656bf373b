import { numberedFromZero } from "../../nc/edit.ts";
import { Icon, type IconName } from "../../app/base/Icon.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { toggleAllFolds } from "../../app/fields/blocks/folding.ts";
import { editProgram, readWhole, sessionView, useSession } from "../../app/fields/blocks/session.ts";
import { FindBar } from "../../app/fields/find/FindBar.tsx";
import { GoToBar } from "../../app/fields/find/GoToBar.tsx";
import type { TextBar } from "../../app/fields/find/text-bar.ts";
import { useActions } from "../../app/base/actions.ts";
import { editorText, goToPlace } from "./editor-text.ts";

function renumber(): void {
  readWhole();
  editProgram(numberedFromZero(useSession.getState().reading.program), null);
}

function foldAll(): void {
  const view = sessionView();
  if (view) toggleAllFolds(view);
}

/** Finds, goes to, folds and numbers in the text of a program; the bar is open above the text. */
export function TextTools({ bar }: { readonly bar: TextBar }) {
  const t = useTexts("find");
  const reading = useSession((s) => s.reading);
  const { mode, opened } = bar;
  useActions([{ id: "do.renumber", name: t.renumber, run: renumber }]);
  const tool = (icon: IconName, name: string, act: () => void, keys = "") => (
    <button type="button" className="button icon plain" aria-label={name} title={`${name}${keys}`} onClick={act}>
      <Icon name={icon} />
    </button>
  );
  return (
    <>
      <div className="text-tools" role="group" aria-label={t.tools}>
        <button
          type="button"
          className="button plain"
          title={`${t.find} (${t.ctrl}+F)`}
          onClick={() => bar.open("find")}
        >
          <Icon name="search" /> {t.find}
        </button>
        <button
          type="button"
          className="button plain"
          title={`${t.goTo} (${t.ctrl}+G)`}
          onClick={() => bar.open("goTo")}
        >
          <Icon name="goTo" /> {t.goTo}
        </button>
        {tool("foldLines", t.fold, foldAll, ` (${t.shift}+F9)`)}
        {tool("numbers", t.renumber, renumber)}
      </div>
      {mode === "goTo" && <GoToBar bar={bar} program={reading.program} go={goToPlace} leave={editorText.focus} />}
      {mode !== null && mode !== "goTo" && <FindBar key={opened} bar={bar} of={editorText} version={reading} />}
    </>
  );
}
