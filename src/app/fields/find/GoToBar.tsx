import { useEffect, useEffectEvent, useMemo, useRef, type KeyboardEvent } from "react";
import type { Program } from "../../../nc/program.ts";
import { Icon } from "../../base/Icon.tsx";
import { useTexts } from "../../base/settings/use-texts.ts";
import { KEEPS_KEYBOARD } from "../../place/place.ts";
import { ComboboxInput, optionOf, useCombobox } from "./Combobox.tsx";
import type { TextBar } from "./text-bar.ts";
import { placesIn, type TextPlace } from "./text-places.ts";
import "./find.css";

interface Props {
  readonly bar: TextBar;
  readonly program: Program;
  readonly go: (place: TextPlace) => void;
  /** Gives the focus back to the text. */
  readonly leave: () => void;
}

/** Goes to a block, label, tool, cycle, parameter or structure item: they are listed as one types. */
export function GoToBar({ bar, program, go, leave }: Props) {
  const t = useTexts("find");
  const box = useCombobox();
  const { typed } = box;
  const input = useRef<HTMLInputElement>(null);
  const places = useMemo(() => placesIn(program, typed), [program, typed]);
  const begin = useEffectEvent(() => {
    input.current?.focus();
    input.current?.select();
  });
  useEffect(() => begin(), [bar.opened]);

  const close = () => {
    bar.close();
    leave();
  };
  const take = (place: TextPlace | undefined) => {
    if (!place) return;
    bar.close();
    go(place);
  };
  const onKey = (event: KeyboardEvent) => {
    if (event.key !== "Escape") return;
    event.stopPropagation();
    close();
  };
  return (
    <div className="text-bar" role="search" aria-label={t.goTo} onKeyDown={onKey} {...{ [KEEPS_KEYBOARD]: "" }}>
      <div className="text-bar-row">
        <ComboboxInput
          box={box}
          count={places.length}
          label={t.goToLong}
          take={(at) => take(places[at])}
          className="input number"
          input={input}
        />
        <button type="button" className="button icon plain" aria-label={t.close} title={t.close} onClick={close}>
          <Icon name="close" />
        </button>
      </div>
      <p className="unseen" role="status">
        {typed.trim() === "" ? "" : t.count(places.length)}
      </p>
      {typed.trim() !== "" && places.length === 0 && <p className="small soft text-bar-none">{t.count(0)}</p>}
      <ul id={box.id} role="listbox" aria-label={t.goTo} className="go-to-list" hidden={places.length === 0}>
        {places.map((place, i) => (
          <li
            key={`${place.index} ${place.kind} ${place.key} ${place.text}`}
            {...optionOf(box, i, places.length)}
            onClick={() => take(place)}
          >
            <b className="number">{place.key}</b>
            <span className="number go-to-text">{place.text}</span>
            {place.kind !== "block" && <span className="number small soft">{t.block(String(place.number))}</span>}
          </li>
        ))}
      </ul>
    </div>
  );
}
