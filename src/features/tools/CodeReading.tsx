import { formatNumber, inScreenWriting } from "../../i18n/number.ts";
import type { ToolCodeTexts } from "../../i18n/tool-code-text.ts";
import { isHolderFilling, type CodeNote, type Filling } from "../../program/iso-codes/code-cells.ts";
import type { CodePart, CodeMeaning } from "../../program/iso-codes/code-part.ts";
import type { HolderCell } from "../../program/tools/tool-columns.ts";
import { Message } from "../../app/base/Message.tsx";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";

type Number = (n: number) => string;

/** The meaning of a part of a code, in words. */
function meaningOf(meaning: CodeMeaning, w: ToolCodeTexts, number: Number): string {
  switch (meaning.is) {
    case "form":
      return meaning.angle === 0
        ? w.forms[meaning.form]
        : `${w.forms[meaning.form]}, ${w.angle(number(meaning.angle))}`;
    case "angle":
      return w.angle(number(meaning.angle));
    case "mm":
      return w.mm(number(meaning.mm));
    case "tolerance":
      return w.tolerance(
        meaning.from === meaning.to ? number(meaning.from) : `${number(meaning.from)}–${number(meaning.to)}`,
        number(meaning.thickness),
      );
    case "type":
      return `${w.holes[meaning.hole]}, ${w.breakers[meaning.breaker]}`;
    case "wiper":
      return w.wiper(meaning.angle === null ? null : number(meaning.angle));
    case "finish":
      return w.finishes[meaning.finish];
    case "hand":
      return w.hands[meaning.hand];
    case "clamping":
      return w.clampings[meaning.clamping];
    case "style":
      return `${w.angle(number(meaning.angle))}, ${w.cuts[meaning.cuts]}`;
    case "bar":
      return w.makes[meaning.make];
    case "side":
      return w.sides[meaning.side];
    case "pitches": {
      const range =
        meaning.from === meaning.to ? number(meaning.from) : `${number(meaning.from)}–${number(meaning.to)}`;
      return meaning.inch ? w.perInch(range) : w.mm(range);
    }
    case "named":
      return meaning.angle === null ? meaning.name : `${meaning.name}, ${w.angle(number(meaning.angle))}`;
    case "special":
      return w.special;
    case "nothing":
      return "";
  }
}

/** A note about a code, as a sentence. */
function noteOf(note: CodeNote, w: ToolCodeTexts, number: Number): string {
  switch (note.is) {
    case "shapesDiffer":
    case "sizesDiffer":
    case "clearancesDiffer":
      return w.notes[note.is](note.insert, note.holder);
    case "rowAngle":
    case "rowEdge":
      return w.notes[note.is](number(note.row), number(note.code));
    case "unsure":
      return w.notes.unsure(note.letter, number(note.angle));
    case "frontAngle":
      return w.notes.frontAngle(number(note.angle));
    case "noShank":
      return w.notes.noShank[note.why];
    default:
      return w.notes[note.is];
  }
}

const DIFFERENCES = ["shapesDiffer", "sizesDiffer", "clearancesDiffer", "rowAngle", "rowEdge"];

/** A code letter by letter. */
export function CodeParts({ parts, words: w }: { readonly parts: readonly CodePart[]; readonly words: ToolCodeTexts }) {
  const language = useSettings((s) => s.language);
  const number = (n: number) => formatNumber(language, n, 3);
  return (
    <ul className="code-parts" aria-label={w.says}>
      {parts.map(({ name, text, meaning, sure }, i) => {
        const said = meaning ? meaningOf(meaning, w, number) : w.unknownPart;
        const whole = said === "" ? w.parts[name] : w.part(w.parts[name], said);
        return (
          <li key={i} className={meaning ? "" : "wrong"}>
            <b className="number">{text}</b> <span>{sure ? whole : `${whole} (${w.unsure})`}</span>
          </li>
        );
      })}
    </ul>
  );
}

/** The cells that a code fills, each with its present value. */
export function CodeFillings({
  cells,
  words: w,
}: {
  readonly cells: readonly Filling[];
  readonly words: ToolCodeTexts;
}) {
  const t = useTexts("tables").tools;
  const language = useSettings((s) => s.language);
  const shown = (cell: string, text: string, outline: string) =>
    text.trim() === "" ? w.empty : cell === "head" ? outline : inScreenWriting(language, text);
  return (
    <ul className="code-fills" aria-label={w.fills}>
      {cells.map((filling) => (
        <li key={filling.cell}>
          <span className={isHolderFilling(filling) ? "" : "number"}>
            {isHolderFilling(filling) ? t.holder[filling.cell as HolderCell] : filling.cell}
          </span>{" "}
          <span className="soft number">{shown(filling.cell, filling.from, w.outline)}</span> →{" "}
          <b className="number">{shown(filling.cell, filling.to, w.newOutline)}</b>
        </li>
      ))}
    </ul>
  );
}

/** Notes before a code is applied; contradictions have a warning sign. */
export function CodeNotes({ notes, words: w }: { readonly notes: readonly CodeNote[]; readonly words: ToolCodeTexts }) {
  const language = useSettings((s) => s.language);
  return notes.map((note, i) => {
    const differs = DIFFERENCES.includes(note.is);
    return (
      <Message key={i} tone={differs ? "warning" : "info"}>
        {noteOf(note, w, (n) => formatNumber(language, n, 3))}
      </Message>
    );
  });
}
