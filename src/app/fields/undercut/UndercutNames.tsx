import { useEffect, useId, useRef, useState } from "react";
import type { UndercutTexts } from "../../../i18n/en/undercuts.ts";
import { formatNumber } from "../../../i18n/number.ts";
import { undercutsNamed, type NamedUndercut, type UndercutPlace } from "../../../program/job/undercut-name.ts";
import { withThreadBeside } from "../../../program/edits/thread-beside.ts";
import { useOutcome } from "../../calculation/outcome.ts";
import { Message } from "../../base/Message.tsx";
import { useSettings } from "../../base/settings/settings.ts";
import { ComboboxInput, optionOf, useCombobox } from "../find/Combobox.tsx";
import { nameText, noteText, sizesText } from "./undercut-text.ts";
import "./undercut.css";

interface Props {
  readonly words: UndercutTexts;
  /** Name of the field. */
  readonly label: string;
  /** Null while the corner is unknown. */
  readonly place: UndercutPlace | null;
  /** The designation in use; null for none. */
  readonly present: NamedUndercut | null;
  readonly onTake: (named: NamedUndercut) => void;
  /** What the place of the undercut leaves of the designation in use. */
  readonly hint?: string | null;
  /** Typed already when it is shown. */
  readonly begun?: string;
  /** Takes the focus when it is shown. */
  readonly isNew?: boolean;
  readonly field?: Readonly<Record<`data-${string}`, string>>;
}

/** No option is chosen before one is typed for or an arrow is pressed: Enter in an empty field goes on. */
const NONE = -1;

/** Finds an undercut by its designation: by what is typed, or among those for the diameter. */
export function UndercutNames({
  words: t,
  label,
  place,
  present,
  onTake,
  hint = null,
  begun = "",
  isNew = false,
  field = {},
}: Props) {
  const language = useSettings((s) => s.language);
  const box = useCombobox(NONE, begun);
  const own = useRef<HTMLDivElement>(null);
  const input = useRef<HTMLInputElement>(null);
  const id = useId();
  const [open, setOpen] = useState(false);
  const [said, say] = useState("");
  useEffect(() => {
    // Shown late, while another value is typed already, it leaves the focus there.
    const at = document.activeElement;
    if (isNew && !(at instanceof HTMLInputElement)) input.current?.focus();
  }, [isNew]);
  const write = (n: number) => formatNumber(language, n, 3);
  const operations = useOutcome((s) => s.newest?.run.operations);
  const { sizes, notes } = undercutsNamed(box.typed, place && withThreadBeside(place, operations ?? []));
  const usable = sizes.filter(({ udc }) => udc !== null);
  const without = sizes.filter(({ udc }) => udc === null);
  const isUnknown = box.typed.trim() !== "" && sizes.length === 0 && notes.length === 0;
  const take = (named: NamedUndercut) => {
    onTake(named);
    box.change({ typed: "", chosen: NONE });
    setOpen(false);
    say(t.taken(nameText(named.name, write)));
  };
  return (
    <div
      ref={own}
      className="undercut-named"
      // The letters and arrows of a designation are no commands of a table around it.
      onKeyDown={(e) => {
        if (e.key === "Tab" || e.ctrlKey || e.metaKey || (e.key === "Escape" && !open)) return;
        if (e.key === "Enter" && box.typed === "" && box.chosen === NONE) return;
        if (e.key === "Escape") {
          e.preventDefault();
          setOpen(false);
        } else if (e.key !== "Enter") setOpen(true);
        e.stopPropagation();
      }}
      onFocus={() => setOpen(true)}
      onBlur={(e) => {
        if (!own.current?.contains(e.relatedTarget)) setOpen(false);
      }}
    >
      <div className="undercut-field">
        <span className="small soft" aria-hidden="true">
          {t.label}
        </span>
        <ComboboxInput
          box={box}
          input={input}
          count={open ? usable.length : 0}
          label={label}
          placeholder={present ? nameText(present.name, write) : t.example}
          take={(index) => {
            const found = usable[index];
            if (found) take(found);
          }}
          className="input"
          describedBy={id}
          field={field}
        />
      </div>
      {open && usable.length > 0 && (
        <ul id={box.id} role="listbox" tabIndex={-1} aria-label={t.sizes} className="undercut-sizes">
          {usable.map((each, i) => (
            <li key={each.name} {...optionOf(box, i, usable.length)} onClick={() => take(each)}>
              <strong>{nameText(each.name, write)}</strong>
              <span className="small soft number">{sizesText(each, write)}</span>
              {each.load && <span className="small soft">{t.load[each.load]}</span>}
              {each.notes.map((note) => (
                <span key={note.code} className="small undercut-note">
                  {noteText(t, note, write)}
                </span>
              ))}
            </li>
          ))}
        </ul>
      )}
      <div id={id} className="undercut-said">
        {isUnknown && <Message tone="warning">{t.none}</Message>}
        {open && !place && <p className="small soft">{t.noPlace}</p>}
        {[...notes, ...without.flatMap((each) => each.notes)].map((note) => (
          <Message key={note.code} tone="warning">
            {noteText(t, note, write)}
          </Message>
        ))}
        {present && (
          <p className="small soft">
            <strong>{nameText(present.name, write)}</strong> <span className="number">{sizesText(present, write)}</span>
          </p>
        )}
        {present?.notes.map((note) => (
          <Message key={note.code} tone="info" className="small">
            {noteText(t, note, write)}
          </Message>
        ))}
        {hint !== null && (
          <Message tone="info" className="small">
            {hint}
          </Message>
        )}
        {(open || present) && <p className="small soft">{t.source}</p>}
      </div>
      <p role="status" className="unseen">
        {said}
      </p>
    </div>
  );
}
