import { useEffect, useLayoutEffect, useRef } from "react";
import { createPortal } from "react-dom";
import { decimalSign } from "../../../i18n/number.ts";
import { FIELD_ROWS } from "../dialog/key-rows.ts";
import { padButton, writingKeys, type PadKey } from "../dialog/KeyGrid.tsx";
import { useMedia } from "../../base/use-media.ts";
import { useSettings } from "../../base/settings/settings.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { enterField, fieldEntry, scopeOf, stepField, writeEntry } from "./field-typing.ts";
import "./keypad.css";

/** Keypad for the focused number field at the lower edge of the page, which makes room for it. */
export function FieldKeypad({
  field,
  onLetters,
}: {
  readonly field: HTMLInputElement;
  /** Requests the device keyboard for this field. */
  readonly onLetters: (field: HTMLInputElement) => void;
}) {
  const {
    dialog: { keys: t, keypad },
  } = useTexts();
  const sign = decimalSign(useSettings((s) => s.language));
  const flat = useMedia("flat");
  const box = useRef<HTMLDivElement>(null);

  useLayoutEffect(() => {
    document.documentElement.style.setProperty("--keypad", `${box.current?.offsetHeight ?? 0}px`);
    return () => {
      document.documentElement.style.removeProperty("--keypad");
    };
  }, [flat]);
  useEffect(() => {
    field.scrollIntoView?.({ block: "nearest" });
  }, [field]);

  const writing = writingKeys(t, sign, true, (by) => () => {
    if (field.isConnected) writeEntry(field, by(fieldEntry(field)));
  });
  const keys: Readonly<Record<string, PadKey>> = {
    up: { label: "▲", name: t.previousField, press: () => stepField(field, -1) },
    down: { label: "▼", name: t.nextField, press: () => stepField(field, 1) },
    letters: { label: t.letters, name: t.lettersLong, press: () => onLetters(field), className: "small" },
    ready: { label: t.ready, name: t.readyLong, press: () => field.blur(), className: "small ready" },
    "?": { ...writing("?"), name: t.notGiven },
    enter: { label: "ENT", name: t.enterField, press: () => enterField(field), className: "primary enter" },
  };
  return createPortal(
    <section className="field-keypad-place" aria-label={keypad}>
      <div className={`keypad field-keypad${flat ? " flat" : ""}`} role="group" aria-label={keypad} ref={box}>
        {FIELD_ROWS[field.dataset["number"] === "open" ? "open" : "words"][flat ? "flat" : "high"].map((id) =>
          padButton(keys[id] ?? writing(id), false),
        )}
      </div>
    </section>,
    scopeOf(field),
  );
}
