import { useEffect, useRef, useState } from "react";
import { markFresh } from "../../app/fields/blocks/fresh-block.ts";
import { cycleByNumber } from "../../cycles/index.ts";
import { CycleChooser } from "../../app/fields/chooser/CycleChooser.tsx";
import { ownStatement } from "../../program/edits/own-cycle.ts";
import { focusPart } from "../../app/base/focus-guard.ts";
import { Icon } from "../../app/base/Icon.tsx";
import type { Statement } from "../../nc/statement.ts";
import { useOwnOffer } from "../../app/fields/own/OwnCycles.tsx";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useFingers } from "../../app/base/use-media.ts";
import { usePlace } from "../../app/place/place.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { inserted } from "../../app/fields/blocks/block-edits.ts";
import { BlockKinds } from "./BlockKinds.tsx";
import { cycleStatement, type Offered } from "./palette.ts";
import { editProgram, useSession } from "../../app/fields/blocks/session.ts";

interface Props {
  readonly index: number;
  readonly done: () => void;
}

const FORM = ".block-panel [role=form]";

/** Moves the focus to the first field of the dialog that replaces the palette. */
const enterForm = (): void =>
  focusPart(FORM, () => {
    usePlace.setState((p) => ({ focus: p.focus + 1 }));
    const field = document.querySelector<HTMLElement>(`${FORM} :is(input, select, textarea)`);
    field?.focus({ preventScroll: true });
    // As with Tab: typing replaces the value that the new block begins with.
    if (field instanceof HTMLInputElement) field.select();
  });

/** All kinds of blocks; a click inserts one after the open block and opens its dialog. */
export function Palette({ index, done }: Props) {
  const t = useTexts();
  const language = useSettings((s) => s.language);
  const program = useSession((s) => s.reading.program);
  const box = useRef<HTMLDivElement>(null);
  const [cycles, showCycles] = useState(false);
  // A field with the focus opens the keyboard of a touch screen.
  const fingers = useFingers();
  // Takes focus from the clicked button it replaces; focus elsewhere stays.
  useEffect(() => {
    if (!cycles && document.activeElement === document.body)
      box.current?.querySelector<HTMLElement>(fingers ? "button" : "input")?.focus({ preventScroll: true });
  }, [cycles, fingers]);

  const put = (statement: Statement) => {
    if (statement.kind === "approach") markFresh(index + 1);
    editProgram(inserted(program, index + 1, statement), null, index + 1);
    done();
    if (!fingers) enterForm();
  };
  const putCycle = (number: number) => {
    const cycle = cycleByNumber(number);
    if (cycle) put(cycleStatement(cycle, language));
  };
  const choose = (offered: Offered) => (offered.make ? put(offered.make(language)) : showCycles(true));
  const own = useOwnOffer(t.chooser.insert, (cycle) => put(ownStatement(cycle)));
  return (
    <div
      className="palette"
      ref={box}
      role="group"
      aria-label={t.editor.palette}
      onKeyDown={(event) => {
        if (event.key !== "Escape") return;
        if (cycles) showCycles(false);
        else done();
      }}
    >
      <header className="block-head">
        {cycles && (
          <button type="button" className="button" onClick={() => showCycles(false)}>
            <Icon name="back" /> {t.chooser.back}
          </button>
        )}
        <h2>{cycles ? t.chooser.cycles : t.editor.palette}</h2>
        <button type="button" className="button icon plain" aria-label={t.page.close} onClick={done}>
          <Icon name="close" />
        </button>
      </header>
      {cycles && (
        <CycleChooser
          narrow
          inProgram
          focus
          more={own}
          ways={[{ name: t.chooser.insert, short: t.chooser.insert, go: putCycle }]}
        />
      )}
      {!cycles && <BlockKinds choose={choose} chooseCycle={putCycle} />}
    </div>
  );
}
