import { useId, useRef, useState } from "react";
import { fillingOf, isWholeCode, nameOfCodes } from "../../program/iso-codes/code-cells.ts";
import { readToolCodes } from "../../program/iso-codes/tool-code.ts";
import { cellOf, type ToolEntry } from "../../program/tools/tool-entry.ts";
import { Message } from "../../app/base/Message.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { CodeFillings, CodeNotes, CodeParts } from "./CodeReading.tsx";
import { setCells } from "./tool-edits.ts";

/** The code of an insert or a holder, parsed at each keystroke; Enter fills its columns, as one step. */
export function CodeField({ entry }: { readonly entry: ToolEntry }) {
  const w = useTexts("tool-codes");
  const id = useId();
  const input = useRef<HTMLInputElement>(null);
  const [typed, type] = useState("");
  const [said, say] = useState("");
  const codes = readToolCodes(typed);
  const { cells, notes } = fillingOf(codes, entry);
  const name = cellOf(entry, "NAME");
  const named = readToolCodes(name);
  const offersName = typed === "" && isWholeCode(named) && fillingOf(named, entry).cells.length > 0;

  const take = () => {
    if (cells.length === 0) return;
    setCells(entry.id, Object.fromEntries(cells.map(({ cell, to }) => [cell, to])));
    say(w.taken(nameOfCodes(codes), cells.length));
    type("");
    input.current?.focus();
  };
  return (
    <div className="tool-field wide code-field">
      <label htmlFor={id}>{w.label}</label>
      <input
        id={id}
        ref={input}
        className="input number name"
        type="text"
        autoComplete="off"
        autoCapitalize="characters"
        spellCheck={false}
        maxLength={80}
        data-enter="own"
        aria-describedby={`${id}-hint`}
        value={typed}
        onChange={(e) => {
          type(e.currentTarget.value);
          say("");
        }}
        onKeyDown={(e) => {
          if (e.key === "Enter") take();
          else if (e.key === "Escape" && typed !== "") {
            e.stopPropagation();
            type("");
          }
        }}
      />
      <span className="soft small" id={`${id}-hint`}>
        {w.hint}
      </span>
      {offersName && (
        <button
          type="button"
          className="button"
          onClick={() => {
            type(name);
            input.current?.focus();
          }}
        >
          {w.readName(name)}
        </button>
      )}
      {[codes.holder, codes.insert, codes.maker].map(
        (code) => code && <CodeParts key={code.kind} parts={code.parts} words={w} />,
      )}
      <div role="status" className="field-messages">
        {codes.notCovered && <Message tone="warning">{w.notCovered[codes.notCovered]}</Message>}
        <CodeNotes notes={notes} words={w} />
        {said !== "" && <Message tone="info">{said}</Message>}
        {typed.trim() !== "" && !codes.notCovered && cells.length === 0 && <p className="soft small">{w.nothing}</p>}
      </div>
      {cells.length > 0 && (
        <>
          <CodeFillings cells={cells} words={w} />
          <button type="button" className="button primary" onClick={take}>
            {w.take}
          </button>
        </>
      )}
    </div>
  );
}
