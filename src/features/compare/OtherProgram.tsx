import { useEffect, useId, useState } from "react";
import { decodeAny } from "../../app/document/encoding.ts";
import { useShownName } from "../../app/document/shown-file.ts";
import { askForFiles } from "../../app/records/files/file-handle.ts";
import { readWork } from "../../app/records/device.ts";
import { refreshWorks, useSavedWorks } from "../../app/records/keep.ts";
import { useEditor } from "../../app/document/store.ts";
import type { ProgramWork } from "../../app/document/work.ts";
import { openedProgram, textOfFile, withOtherText, type ComparedProgram } from "../../app/fields/compare/sides.ts";
import { asProgram } from "../../app/document/printed.ts";
import type { CompareTexts } from "../../i18n/en/compare.ts";

/** Source of the other program: values of the select. */
const OPENED = "opened";
const DEVICE = "device";
const ELSEWHERE = "elsewhere";

const isProgramText = (text: string): boolean => /[A-Z]/i.test(text);

/** Asks for the program to compare with. */
export function OtherProgram({
  words,
  present,
  other,
  onTake,
}: {
  readonly words: CompareTexts;
  readonly present: ProgramWork;
  readonly other: ComparedProgram | null;
  readonly onTake: (other: ComparedProgram | null) => void;
}) {
  const id = useId();
  const work = useEditor((s) => s.work);
  const works = useSavedWorks((k) => k.works).filter((each) => each.work !== work);
  const [from, choose] = useState(() => (other ? (other.name === null ? OPENED : ELSEWHERE) : ""));
  const [problem, say] = useState<"unreadable" | "empty" | null>(null);
  const [pasting, paste] = useState(false);

  const take = (found: ComparedProgram | null) => {
    say(found ? null : "unreadable");
    onTake(found);
  };
  const takeText = (name: string, text: string) => take({ name, program: withOtherText(present, text) });
  const pick = async (chosen: string) => {
    choose(chosen);
    paste(false);
    if (chosen === DEVICE) return fromDevice();
    if (chosen === "") return onTake(null);
    const kept = chosen === OPENED ? null : ((await readWork(chosen))?.job ?? null);
    const program = chosen === OPENED ? openedProgram() : kept && asProgram(kept);
    const name = works.find((each) => each.work === chosen)?.name ?? null;
    take(program && { name, program });
  };
  const shown = useShownName();
  const [onDevice, find] = useState(false);
  useEffect(() => {
    void refreshWorks();
    if (work !== null)
      void import("../../app/records/files/kept-handles.ts").then(async ({ keptHandle }) =>
        find((await keptHandle(work, shown)) !== null),
      );
  }, [work, shown]);
  const pickFile = async () => {
    const [found] = await askForFiles();
    if (!found) return;
    choose(ELSEWHERE);
    const text = await textOfFile(found.file);
    if (text === null) take(null);
    else takeText(found.file.name, text);
  };
  const fromDevice = async () => {
    const { bytesOnDevice } = await import("../../app/records/files/save-back.ts");
    const bytes = work === null ? null : await bytesOnDevice(work, shown);
    if (bytes) takeText(words.disk(shown), decodeAny(bytes).text);
    else take(null);
  };
  const fromClipboard = async () => {
    choose(ELSEWHERE);
    try {
      const text = await navigator.clipboard.readText();
      if (isProgramText(text)) takeText(words.clipboard, text);
      else {
        onTake(null);
        say("empty");
      }
    } catch {
      onTake(null);
      paste(true);
    }
  };

  return (
    <div className="compare-other">
      <label htmlFor={id}>{words.with}</label>
      <select id={id} className="select" value={from} onChange={(event) => void pick(event.currentTarget.value)}>
        <option value="">{words.choose}</option>
        {from === ELSEWHERE && <option value={ELSEWHERE}>{other?.name ?? words.file}</option>}
        <option value={OPENED}>{words.opened}</option>
        {onDevice && <option value={DEVICE}>{words.disk(shown)}</option>}
        {works.length > 0 && (
          <optgroup label={words.kept}>
            {works.map((each) => (
              <option key={each.work} value={each.work}>
                {each.name}
              </option>
            ))}
          </optgroup>
        )}
      </select>
      <button type="button" className="button" onClick={() => void pickFile()}>
        {words.file}
      </button>
      <button type="button" className="button" onClick={() => void fromClipboard()}>
        {words.clipboard}
      </button>
      {pasting && (
        <label className="compare-paste">
          <span>{words.noClipboard}</span>
          <textarea
            className="number"
            rows={5}
            spellCheck={false}
            aria-label={words.paste}
            onChange={(event) => {
              const text = event.currentTarget.value;
              if (isProgramText(text)) takeText(words.clipboard, text);
            }}
          />
        </label>
      )}
      {problem && (
        <p role="status" className="compare-problem">
          {words[problem]}
        </p>
      )}
    </div>
  );
}
