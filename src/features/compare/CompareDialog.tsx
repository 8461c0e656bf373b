import { useMemo, useRef, useState } from "react";
import { createPortal } from "react-dom";
import type { BlockDifference } from "../../program/compare/compare.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { useLengths } from "../../app/calculation/lengths.ts";
import { copyText, useCopying } from "../../app/findings/copy.ts";
import { useTexts, useTextsOrNull } from "../../app/base/settings/use-texts.ts";
import { useEditor, openContent } from "../../app/document/store.ts";
import { comparisonText, findingTexts, summaryText, verdictChange, wholeTexts, type Wording } from "./compare-words.ts";
import { isFormattingOnly, tallyOf, type ComparedFile } from "./compared.ts";
import { Differences, rowsIn } from "./Differences.tsx";
import { OtherProgram } from "./OtherProgram.tsx";
import type { OtherText, ShowBlock } from "../../app/place/place.ts";
import { changedSinceOpened, presentProgram, withOtherText } from "../../app/fields/compare/sides.ts";
import { useProgramComparison, type ComparedPrograms } from "./use-compared.ts";
import { ModalDialog } from "../../app/base/ModalDialog.tsx";
import { lazyPart } from "../../app/base/parts.ts";
import "./compare.css";

const BetterWaysDialog = lazyPart(async () => ({
  default: (await import("./BetterWaysDialog.tsx")).BetterWaysDialog,
}));

/** Block of the current program that a difference leads to: its own, or the place of a removed block. */
function targetBlock({ after, partners }: ComparedFile, { a, b }: BlockDifference): number {
  if (b !== null) return b;
  for (let i = a ?? 0; i >= 0; i -= 1) {
    const partner = partners[i] ?? -1;
    if (partner >= 0) return Math.min(partner + 1, after.blocks.length - 1);
  }
  return 0;
}

function Whole({
  wording,
  compared: { files, consequences, state },
}: {
  readonly wording: Wording;
  readonly compared: ComparedPrograms;
}) {
  const { words } = wording;
  const changed = consequences && verdictChange(wording, consequences);
  const effects = consequences ? wholeTexts(wording, consequences) : [];
  return (
    <section className="compare-whole" aria-label={words.whole}>
      <p role="status" className="compare-summary">
        {summaryText(wording, files, consequences)}
      </p>
      {state !== "done" && <p className="soft">{state === "failed" ? words.notCalculated : words.calculating}</p>}
      {changed && (
        <p>
          {words.verdict}: {changed}
        </p>
      )}
      {effects.length > 0 && (
        <ul className="compared-effects" aria-label={words.whole}>
          {effects.map(({ name, text }) => (
            <li key={name} className="number">
              {text}
            </li>
          ))}
        </ul>
      )}
      {consequences &&
        (["went", "came"] as const).map(
          (which) =>
            consequences[which].length > 0 && (
              <div key={which} className="compare-findings">
                <b>{words[which]}</b>
                <ul>
                  {findingTexts(wording, consequences[which]).map((text, i) => (
                    <li key={i}>{text}</li>
                  ))}
                </ul>
              </div>
            ),
        )}
    </section>
  );
}

/** Focuses the previous or next difference; the first one if none has focus. */
function step(list: ParentNode | null, by: 1 | -1): void {
  const rows = rowsIn(list);
  const at = rows.findIndex((row) => row === document.activeElement || row.matches("[data-last]"));
  const next = rows[at < 0 ? 0 : Math.min(rows.length - 1, Math.max(0, at + by))];
  next?.focus();
  next?.scrollIntoView({ block: "nearest" });
}

function Result({
  wording,
  compared,
  names,
  onChoose,
}: {
  readonly wording: Wording;
  readonly compared: ComparedPrograms;
  readonly names: readonly [string, string];
  readonly onChoose: (file: ComparedFile, difference: BlockDifference) => void;
}) {
  const { words } = wording;
  const list = useRef<HTMLDivElement>(null);
  const [withWriting, showWriting] = useState(false);
  const copied = useCopying((c) => c.state === "copied" && c.text.startsWith(words.title));
  const { written } = tallyOf(compared.files);
  const any = compared.files.some(({ operations }) =>
    operations.some(({ differences }) => differences.some((each) => withWriting || !isFormattingOnly(each))),
  );
  return (
    <>
      <Whole wording={wording} compared={compared} />
      <div className="compare-tools">
        {any && (
          <>
            <button
              type="button"
              className="button icon"
              aria-label={words.previous}
              title={words.previous}
              onClick={() => step(list.current, -1)}
            >
              <Icon name="up" />
            </button>
            <button
              type="button"
              className="button icon"
              aria-label={words.next}
              title={words.next}
              onClick={() => step(list.current, 1)}
            >
              <Icon name="down" />
            </button>
          </>
        )}
        {written > 0 && (
          <label className="check">
            <input
              type="checkbox"
              checked={withWriting}
              onChange={(event) => showWriting(event.currentTarget.checked)}
            />
            <span>
              {words.showWritten} ({written})
            </span>
          </label>
        )}
        <button
          type="button"
          className="button"
          onClick={() =>
            void copyText(comparisonText(wording, names, compared.files, compared.consequences, withWriting))
          }
        >
          <Icon name={copied ? "check" : "copy"} /> {copied ? words.copied : words.copy}
        </button>
        <button type="button" className="button" onClick={() => print()}>
          <Icon name="print" /> {words.print}
        </button>
      </div>
      <div className="compare-names">
        <span>
          {words.from}: <b>{names[0]}</b>
        </span>
        <span>
          {words.to}: <b>{names[1]}</b>
        </span>
      </div>
      <div
        ref={list}
        onFocus={(event) => {
          for (const row of rowsIn(event.currentTarget))
            row.toggleAttribute("data-last", row === document.activeElement);
        }}
      >
        <Differences
          wording={wording}
          files={compared.files}
          consequences={compared.consequences}
          withWriting={withWriting}
          onChoose={onChoose}
        />
      </div>
    </>
  );
}

interface Props {
  readonly done: () => void;
  readonly showBlock: ShowBlock;
  /** Preselected other side; null: the open work as it was opened, if it has changed since. */
  readonly against: OtherText | null;
}

/** Compares the open program with another one, or with better ways for it. */
export function CompareDialog({
  against,
  ...props
}: Omit<Props, "against"> & { readonly against: OtherText | "better" | null }) {
  if (against !== "better") return <OtherDialog {...props} against={against} />;
  return <BetterWaysDialog {...props} />;
}

/** Compares the open program with another one, block by block in meaning, with the effects of the differences. */
function OtherDialog({ done, showBlock, against }: Props) {
  const texts = useTexts();
  const lengths = useLengths();
  const dialog = useRef<HTMLDialogElement>(null);
  const words = useTextsOrNull("compare");
  const [present] = useState(presentProgram);
  const [other, take] = useState(
    () =>
      present &&
      (against ? { name: against.name, program: withOtherText(present, against.text) } : changedSinceOpened(present)),
  );
  const name = useEditor((s) => openContent(s)?.name ?? "");
  const sides = useMemo(() => (present && other ? { before: other.program, after: present } : null), [present, other]);
  const compared = useProgramComparison(sides);

  const choose = (file: ComparedFile, difference: BlockDifference) => {
    dialog.current?.close();
    const index = targetBlock(file, difference);
    showBlock(file.isMain ? null : file.name, index, file.numbers.after[index] ?? 0);
  };
  return createPortal(
    <ModalDialog ref={dialog} className="modal compare" title={words?.title} done={done}>
      {words && present && (
        <>
          <OtherProgram words={words} present={present} other={other} onTake={take} />
          {other && !compared && <p className="soft">{words.working}</p>}
          {other && compared && (
            <Result
              wording={{ texts, words, lengths }}
              compared={compared}
              names={[other.name ?? words.opened, name]}
              onChoose={choose}
            />
          )}
        </>
      )}
    </ModalDialog>,
    document.body,
  );
}
