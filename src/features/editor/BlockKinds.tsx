import { useMemo, useRef, useState, type KeyboardEvent } from "react";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { offeredCycles } from "../../app/fields/chooser/menu.ts";
import { findCycles, withoutAccents } from "../../app/fields/chooser/search.ts";
import { useMenuWords } from "../../app/fields/chooser/use-menu-words.ts";
import { ncWordOf, palette, plainName, type Offered } from "./palette.ts";

const groups = [...new Set(palette.map((offered) => offered.group))];

interface Props {
  readonly choose: (offered: Offered) => void;
  readonly chooseCycle: (number: number) => void;
}

/** A row: the word of the program first, then its plain name. */
interface Row {
  readonly id: string;
  readonly word: string;
  readonly name: string;
  readonly go: () => void;
}

/** All kinds of blocks by group; typing filters them by word and name, and finds cycles. */
export function BlockKinds({ choose, chooseCycle }: Props) {
  const t = useTexts();
  const { menu, page } = useTexts("first");
  const language = useSettings((s) => s.language);
  const [typed, type] = useState("");
  const box = useRef<HTMLDivElement>(null);
  const sought = withoutAccents(typed.trim());
  const languages = useMenuWords(sought !== "");
  const rows = useMemo(
    () =>
      palette.map((offered) => ({
        id: offered.kind,
        group: offered.group,
        word: ncWordOf(offered, language),
        name: plainName(t.editor.kinds[offered.kind]),
        go: () => choose(offered),
      })),
    [t, language, choose],
  );
  const shown = rows.filter(({ word, name }) => withoutAccents(`${word} ${name}`).includes(sought));
  const cycles: readonly Row[] =
    sought === ""
      ? []
      : findCycles(offeredCycles(true), sought, languages).map(({ number }) => ({
          id: `cycle ${number}`,
          word: `CYCL DEF ${number}`,
          name: menu.of[number]?.name ?? "",
          go: () => chooseCycle(number),
        }));
  const [first] = [...shown, ...cycles];

  const onKey = (event: KeyboardEvent<HTMLElement>) => {
    const { key, target } = event;
    if (key === "Enter" && target instanceof HTMLInputElement) {
      event.preventDefault();
      first?.go();
      return;
    }
    if (key !== "ArrowDown" && key !== "ArrowUp") return;
    const stops = [...(box.current?.querySelectorAll<HTMLElement>("input, .palette-kind") ?? [])];
    event.preventDefault();
    stops[Math.max(0, stops.indexOf(target as HTMLElement) + (key === "ArrowDown" ? 1 : -1))]?.focus();
  };
  const section = (name: string, own: readonly Row[]) =>
    own.length > 0 && (
      <section key={name} aria-label={name}>
        <h3 className="panel-title">{name}</h3>
        {own.map(({ id, word, name: plain, go }) => (
          <button key={id} type="button" className="palette-kind" onClick={go}>
            <b className="number">{word}</b> <span>{plain}</span>
          </button>
        ))}
      </section>
    );
  return (
    <div ref={box} className="palette-kinds" onKeyDown={onKey}>
      <input
        type="search"
        className="input"
        aria-label={t.editor.findBlock}
        placeholder={t.editor.findBlock}
        autoComplete="off"
        spellCheck={false}
        value={typed}
        onChange={(event) => type(event.currentTarget.value)}
        onKeyDown={(event) => {
          if (event.key !== "Escape" || typed === "") return;
          event.stopPropagation();
          type("");
        }}
      />
      <p className="small soft palette-none" role="status">
        {first === undefined && t.editor.nothing}
        {first && sought !== "" && (
          <span className="unseen">
            {page.start.found(shown.length + cycles.length)} {t.chooser.enter(`${first.word} ${first.name}`)}
          </span>
        )}
      </p>
      {groups.map((group) =>
        section(
          t.editor.groups[group],
          shown.filter((row) => row.group === group),
        ),
      )}
      {section(t.chooser.cycles, cycles)}
    </div>
  );
}
