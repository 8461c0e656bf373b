import { useEffect, useMemo, useRef, useState } from "react";
import { createPortal } from "react-dom";
import { ncLanguageOf } from "../../i18n/languages.ts";
import { parse } from "../../nc/parse.ts";
import { fileKey } from "../../program/state/program-files.ts";
import type { BetterWay } from "../../report/better-ways/better-ways.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { ModalDialog } from "../../app/base/ModalDialog.tsx";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts, useTextsOrNull } from "../../app/base/settings/use-texts.ts";
import { useLengths } from "../../app/calculation/lengths.ts";
import { useOutcome } from "../../app/calculation/outcome.ts";
import { showFile } from "../../app/document/shown-file.ts";
import { closeStep, recorded, undo, useIsLastStep, type HistoryStep } from "../../app/document/steps.ts";
import { flushEdits, openDocument, useEditor } from "../../app/document/store.ts";
import { withText, type ProgramWork } from "../../app/document/work.ts";
import { editProgram, readWhole } from "../../app/fields/blocks/session.ts";
import { useCuttingTable, useMaterialOfWork } from "../../app/fields/said/use-advice.ts";
import type { ShowBlock } from "../../app/place/place.ts";
import { Differences } from "./Differences.tsx";
import type { ComparedFile } from "./compared.ts";
import type { BlockDifference } from "../../program/compare/compare.ts";
import { useBetterWays, type WaySearch } from "./use-better-ways.ts";
import { useProgramComparison } from "./use-compared.ts";
import { gainWords, measureWords, operationsIn, subjectWords, type WayWording } from "./way-words.ts";
import "./better-ways.css";

/** Identifies an offer over searches: what it changes. */
const keyOf = ({ subject }: BetterWay): string => JSON.stringify(subject);

/** The block of the present program at a difference: its own, or the one in front of an added block. */
function presentBlock({ partners }: ComparedFile, { a, b }: BlockDifference): number {
  if (a !== null) return a;
  return Math.max(
    0,
    partners.findLastIndex((partner) => partner >= 0 && partner < (b ?? 0)),
  );
}

/** The blocks that a way changes, with the effects on each operation. */
function Changes({
  program,
  way,
  onChoose,
}: {
  readonly program: ProgramWork;
  readonly way: BetterWay;
  readonly onChoose: (index: number, number: number) => void;
}) {
  const texts = useTexts();
  const lengths = useLengths();
  const words = useTextsOrNull("compare");
  const sides = useMemo(
    () => ({ before: program, after: withText(program, fileKey(program.name), way.text) }),
    [program, way.text],
  );
  const compared = useProgramComparison(sides);
  if (!words || !compared) return <p className="soft way-changes">{words?.working}</p>;
  return (
    <div className="way-changes">
      <Differences
        wording={{ texts, words, lengths }}
        files={compared.files}
        consequences={compared.consequences}
        withWriting={false}
        onChoose={(file, difference) => {
          const index = presentBlock(file, difference);
          onChoose(index, file.numbers.before[index] ?? 0);
        }}
      />
    </div>
  );
}

function statusText(words: WayWording["ways"], { state, tried, count, ways, stale }: WaySearch): string {
  if (state === "preparing") return stale.length > 0 ? words.updating : words.preparing;
  if (state === "trying") return words.trying(tried, count);
  if (state === "stopped") return words.stopped(tried, count);
  if (state === "failed") return words.failed;
  if (count === 0) return words.nothing;
  return ways.length === 0 ? words.none(count) : words.found(ways.length, count);
}

interface Props {
  readonly done: () => void;
  readonly showBlock: ShowBlock;
}

/** Improvements of the open program, each tried, shown as a comparison, and used one by one. */
export function BetterWaysDialog({ done, showBlock }: Props) {
  const program = useEditor((s) => s.program);
  const words = useTextsOrNull("better-ways");
  const dialog = useRef<HTMLDialogElement>(null);
  return createPortal(
    <ModalDialog ref={dialog} className="modal compare better-ways" title={words?.title} done={done}>
      {words && program && (
        <Ways
          words={words}
          program={program}
          showBlock={(...place) => {
            dialog.current?.close();
            showBlock(...place);
          }}
        />
      )}
    </ModalDialog>,
    document.body,
  );
}

function Ways({
  words,
  program,
  showBlock,
}: Pick<Props, "showBlock"> & { readonly words: WayWording["ways"]; readonly program: ProgramWork }) {
  const texts = useTexts();
  const lengths = useLengths();
  const { power } = useCuttingTable();
  const { material, own } = useMaterialOfWork();
  const language = useSettings((s) => s.language);
  const conditions = useMemo(
    () => ({ power, material, isStated: own !== undefined, ncLanguage: ncLanguageOf(language) }),
    [power, material, own, language],
  );
  const { search, stop, again } = useBetterWays(program, conditions);
  const knowsChanges = useOutcome((s) => s.newest?.run.timing.contains.includes("toolChange") ?? true);
  const [opened, open] = useState<string | null>(null);
  const [used, note] = useState<{
    readonly key: string;
    readonly what: string;
    readonly step: HistoryStep | null;
  } | null>(null);
  const canUndo = useIsLastStep(used?.step) && used?.step !== null;
  const top = useRef<HTMLDivElement>(null);
  const operations = useMemo(() => operationsIn(search.of.text), [search.of.text]);
  const wording: WayWording = { texts, lengths, ways: words, material, operations };
  const isRunning = search.state === "preparing" || search.state === "trying";
  const isPresent = search.of === program;
  const fresh = new Set(search.ways.map(keyOf));
  const rows = [
    ...search.ways.map((way) => ({ way, isStale: !isPresent })),
    ...search.stale
      .filter((way) => !fresh.has(keyOf(way)) && keyOf(way) !== used?.key)
      .map((way) => ({ way, isStale: true })),
  ];
  const noTime = !knowsChanges && rows.some(({ way: { gains } }) => gains.includes("changes"));

  // A button that disappears with its row must not lose the focus.
  useEffect(() => {
    if (document.activeElement === document.body) top.current?.focus();
  });

  const use = (way: BetterWay) => {
    const what = gainWords(wording, way);
    showFile(null);
    readWhole();
    closeStep();
    const step = recorded(() => {
      editProgram(parse(way.text), null);
      flushEdits();
    });
    closeStep();
    open(null);
    note({ key: keyOf(way), what, step });
    top.current?.focus();
  };
  const undoUsed = () => {
    const document = openDocument();
    if (document !== null) undo(document);
    flushEdits();
    note(null);
    top.current?.focus();
  };

  return (
    <>
      <p className="soft">{words.about}</p>
      <div className="ways-status" ref={top} tabIndex={-1}>
        <p role="status">{statusText(words, search)}</p>
        {isRunning ? (
          <>
            <progress aria-label={words.title} value={search.tried} max={Math.max(1, search.count)} />
            <button type="button" className="button" onClick={stop}>
              {words.stop}
            </button>
          </>
        ) : (
          search.state !== "done" && (
            <button type="button" className="button" onClick={again}>
              {words.again}
            </button>
          )
        )}
      </div>
      {used && canUndo && (
        <p className="ways-used" role="status">
          <Icon name="check" /> <span>{words.used(used.what)}</span>
          <button type="button" className="button" onClick={undoUsed}>
            {words.undo}
          </button>
        </p>
      )}
      {rows.length > 0 && (
        <ol className="ways" aria-label={words.list} aria-busy={isRunning}>
          {rows.map(({ way, isStale }) => {
            const key = keyOf(way);
            const isOpen = key === opened && !isStale;
            const gained = gainWords(wording, way);
            return (
              <li key={key} className={`way${isStale ? " stale" : ""}`}>
                <div className="way-head">
                  <button
                    type="button"
                    className="way-open"
                    aria-expanded={isOpen}
                    disabled={isStale}
                    onClick={() => open(isOpen ? null : key)}
                  >
                    <Icon name={isOpen ? "up" : "down"} />
                    <span className="way-words">
                      <b>{gained}</b>
                      <span>{subjectWords(wording, way)}</span>
                      <span className="way-measures small soft">
                        {measureWords(wording, way).map(({ name, label, text }) => (
                          <span key={name}>
                            {label} <span className="number">{text}</span>
                          </span>
                        ))}
                      </span>
                    </span>
                  </button>
                  <button
                    type="button"
                    className="button"
                    aria-label={words.useLong(gained)}
                    disabled={isStale}
                    onClick={() => use(way)}
                  >
                    {words.use}
                  </button>
                </div>
                {isOpen && (
                  <Changes program={program} way={way} onChoose={(index, number) => showBlock(null, index, number)} />
                )}
              </li>
            );
          })}
        </ol>
      )}
      {search.isFaulty && <p className="small soft">{words.faulty}</p>}
      {noTime && <p className="small soft">{words.noTime}</p>}
      {own === undefined && <p className="small soft">{words.noMaterial}</p>}
    </>
  );
}
