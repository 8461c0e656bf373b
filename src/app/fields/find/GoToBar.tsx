import { useEffect, useEffectEvent, useId, useMemo, useRef, useState, type KeyboardEvent } from "react";
import type { Program } from "../../../nc/program.ts";
import { Icon } from "../../base/Icon.tsx";
import { useTexts } from "../../base/settings/use-texts.ts";
import { KEEPS_KEYBOARD } from "../../place/place.ts";
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
  const id = useId();
  const [typed, type] = useState("");
  const [chosen, choose] = useState(0);
  const input = useRef<HTMLInputElement>(null);
  const list = useRef<HTMLUListElement>(null);
  const places = useMemo(() => placesIn(program, typed), [program, typed]);
  const at = Math.min(chosen, places.length - 1);
  const begin = useEffectEvent(() => {
    input.current?.focus();
    input.current?.select();
  });
  useEffect(() => begin(), [bar.opened]);
  useEffect(() => {
    list.current?.querySelector("[aria-selected=true]")?.scrollIntoView({ block: "nearest" });
  }, [at]);

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
    const { key } = event;
    if (key === "Escape") {
      event.stopPropagation();
      close();
    } else if (key === "Enter" && event.target === input.current) {
      event.preventDefault();
      take(places[at]);
    } else if (key === "ArrowDown" || key === "ArrowUp") {
      event.preventDefault();
      choose(Math.max(0, Math.min(places.length - 1, at + (key === "ArrowDown" ? 1 : -1))));
    }
  };
  return (
    <div className="text-bar" role="search" aria-label={t.goTo} onKeyDown={onKey} {...{ [KEEPS_KEYBOARD]: "" }}>
      <div className="text-bar-row">
        <input
          ref={input}
          type="text"
          className="input number"
          role="combobox"
          aria-label={t.goToLong}
          placeholder={t.goToLong}
          aria-expanded={places.length > 0}
          aria-controls={id}
          aria-autocomplete="list"
          aria-activedescendant={places[at] ? `${id}${at}` : undefined}
          enterKeyHint="go"
          autoComplete="off"
          autoCapitalize="none"
          spellCheck={false}
          value={typed}
          onChange={(event) => {
            type(event.currentTarget.value);
            choose(0);
          }}
        />
        <button type="button" className="button icon plain" aria-label={t.close} title={t.close} onClick={close}>
          <Icon name="close" />
        </button>
      </div>
      <p className="unseen" role="status">
        {typed.trim() === "" ? "" : t.count(places.length)}
      </p>
      {typed.trim() !== "" && places.length === 0 && <p className="small soft text-bar-none">{t.count(0)}</p>}
      <ul ref={list} id={id} role="listbox" aria-label={t.goTo} className="go-to-list" hidden={places.length === 0}>
        {places.map((place, i) => (
          <li
            key={`${place.index} ${place.kind} ${place.key} ${place.text}`}
            id={`${id}${i}`}
            role="option"
            aria-selected={i === at}
            onPointerDown={(event) => event.preventDefault()}
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
