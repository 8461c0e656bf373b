import { Suspense, useId, useState } from "react";
import { blockNumbers, startLines } from "../../nc/program.ts";
import { cycleByNumber, type CycleNumber } from "../../cycles/index.ts";
import { isUnsimulated } from "../../cycles/unsimulated-cycles.ts";
import type { Texts } from "../../i18n/index.ts";
import { ApproachBlock } from "./approach/ApproachBlock.tsx";
import { CycleDialog } from "../../app/fields/dialog/CycleDialog.tsx";
import { Icon, type IconName } from "../../app/base/Icon.tsx";
import type { OwnBlock } from "../../app/fields/blocks/own-block.ts";
import { OwnDialog } from "../../app/fields/own/OwnDialog.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { duplicated, exchanged, removed } from "../../app/fields/blocks/block-edits.ts";
import { BlockForm, NEXT_STEP } from "./BlockForm.tsx";
import { kindOf } from "../../app/fields/blocks/block-kind.ts";
import { retoolBlock } from "./retool-block.ts";
import { Palette } from "./Palette.tsx";
import { setBlockPrompt, setBlockPrompts, useOpenBlock } from "../../app/fields/blocks/open-block.ts";
import { askForOperation } from "../../app/document/inserting.ts";
import { operationAt } from "../../program/edits/operations.ts";
import { useSuggestedSizes } from "../../app/fields/blocks/suggested-sizes.ts";
import { editProgram, ofText, openBlock, useSession } from "../../app/fields/blocks/session.ts";

/** The name of a cycle on the screen; null for an unknown one. */
function nameOf(t: Texts, cycle: number, own: OwnBlock | null): string | null {
  if (cycleByNumber(cycle)) return t.cycles.of[cycle as CycleNumber].name;
  return isUnsimulated(cycle) ? t.cycles.kept[cycle] : (own?.own.name ?? null);
}

/** The dialog of the open block, and the actions on the block. */
export function BlockPanel() {
  const t = useTexts();
  const {
    reading: { program },
    index,
  } = useSession();
  const isOpen = useSession(ofText);
  const { read, own, problems } = useOpenBlock();
  const sizes = useSuggestedSizes(index, read?.cycle.number ?? null);
  const [choosing, choose] = useState(false);
  const title = useId();
  const block = program.blocks[index];
  const last = program.blocks.length - 1;

  if (!isOpen) return null;
  if (choosing || !block) {
    return (
      <div className="block-panel">
        {!block && <p className="soft">{t.editor.noBlock}</p>}
        <Palette index={index} done={() => choose(false)} />
      </div>
    );
  }
  const s = block.statement;
  const words = s.kind === "cycle" ? nameOf(t, s.cycle, own) : null;
  const kind = words ?? t.editor.kinds[kindOf(s)];
  const number = String(blockNumbers(program)[index] ?? 0);
  const line = startLines(program)[index] ?? 1;
  const dialogOf = () => {
    if (read) {
      const prompted = {
        line,
        problems,
        sizes,
        onInsert: () => askForOperation(operationAt(program, index)),
        set: setBlockPrompt,
        setAll: setBlockPrompts,
        takeTool: (T: number) => retoolBlock(program, index, T),
      };
      return <CycleDialog key={index} read={read} block={prompted} />;
    }
    if (own)
      return (
        <Suspense key={index}>
          <OwnDialog block={own} problems={problems} set={setBlockPrompt} />
        </Suspense>
      );
    if (s.kind === "approach") return <ApproachBlock key={index} problems={problems} />;
    return <BlockForm key={index} problems={problems} />;
  };
  const tool = (icon: IconName, name: string, act: () => void, disabled = false) => (
    <button
      type="button"
      className="button icon plain"
      aria-label={name}
      title={name}
      disabled={disabled}
      onClick={act}
    >
      <Icon name={icon} />
    </button>
  );

  return (
    // Named as a group, so that a jump to one of its controls says which block it is.
    <div className="block-panel" role="group" aria-labelledby={title}>
      <header className="block-head">
        <h2 id={title}>{t.editor.heading(number, kind)}</h2>
      </header>
      <div className="block-tools" role="group" aria-label={t.editor.tools}>
        <button
          type="button"
          className="button"
          aria-label={t.editor.insertLong}
          onClick={() => choose(true)}
          {...{ [NEXT_STEP]: "" }}
        >
          <Icon name="add" /> <span>{t.editor.insert}</span>
        </button>
        {tool("up", t.editor.previous, () => openBlock(index - 1), index <= 0)}
        {tool("down", t.editor.next, () => openBlock(index + 1), index >= last)}
        {tool("copy", t.editor.duplicate, () => editProgram(duplicated(program, index), null, index + 1))}
        {tool("raise", t.editor.up, () => editProgram(exchanged(program, index - 1), null, index - 1), index <= 0)}
        {tool("lower", t.editor.down, () => editProgram(exchanged(program, index), null, index + 1), index >= last)}
        {tool("remove", t.editor.remove, () => editProgram(removed(program, index), null, Math.min(index, last - 1)))}
      </div>
      {dialogOf()}
    </div>
  );
}
