import { useMemo, useRef, useState, type KeyboardEvent } from "react";
import { Icon } from "../Icon.tsx";
import { useFirstTexts } from "../settings/use-first-texts.ts";
import { useFingers, useMedia } from "../use-media.ts";
import { CycleGroup } from "./CycleGroup.tsx";
import { CycleRow, type CycleWay } from "./CycleRow.tsx";
import { onChooserKey } from "./chooser-keys.ts";
import { notHere, menuGroups, offered } from "./menu.ts";
import { noteRecent } from "./recent.ts";
import { RecentCycles } from "./RecentCycles.tsx";
import { findCycles, findElsewhere } from "./search.ts";
import { useMenuWords } from "./use-menu-words.ts";
import "./chooser.css";

interface Props {
  readonly ways: readonly CycleWay[];
  /** Beside other things: one column, and the groups folded. */
  readonly narrow?: boolean;
  /** A cycle that is chosen is put into a program. */
  readonly inProgram?: boolean;
  /** The search takes the keyboard at once. */
  readonly focus?: boolean;
}

/** All cycles, in the groups of the control: by search, by group, or those that were used last. */
export function CycleChooser({ ways: given, narrow = false, inProgram = false, focus = false }: Props) {
  const { chooser: t, page: { start }, menu: names } = useFirstTexts();
  const phone = useMedia("phone");
  const fingers = useFingers();
  const [typed, type] = useState("");
  const [searching, search] = useState(false);
  const [turn, giveTurn] = useState<number | null>(null);
  const words = useMenuWords(searching);
  const sought = typed.trim();
  const cycles = useMemo(() => offered(inProgram), [inProgram]);
  const found = useMemo(() => (sought === "" ? null : findCycles(cycles, sought, words)), [cycles, sought, words]);
  const beside = useMemo(() => (found?.length === 0 ? findElsewhere(notHere(inProgram), sought, words) : []), [
    found,
    inProgram,
    sought,
    words,
  ]);
  const box = useRef<HTMLDivElement>(null);
  const input = useRef<HTMLInputElement>(null);
  const ways = given.map((way): CycleWay => ({
    ...way,
    go: (cycle) => {
      noteRecent(cycle);
      way.go(cycle);
    },
  }));
  const best = found?.[0];
  const nameOf = (cycle: number) => start.cycle(cycle, names.of[cycle]?.name ?? names.kept[cycle] ?? "");

  const onSearchKey = (event: KeyboardEvent) => {
    if (event.key === "Enter" && best) {
      event.preventDefault();
      ways[0]?.go(best.number);
    } else if (event.key === "Escape" && typed !== "") {
      event.stopPropagation();
      type("");
    }
  };
  return (
    <div className={`cycle-chooser${narrow ? " narrow" : ""}`} ref={box} role="group" aria-label={t.cycles}
      onKeyDown={(event) => onChooserKey(event, input.current)} onFocus={({ target }) => {
      const row = target.closest<HTMLElement>(".cycle-row");
      if (row) giveTurn(Number(row.dataset["cycle"]));
    }}>
      <div className="cycle-search">
        <input ref={input} type="search" className="cycle-search-field" aria-label={t.search} placeholder={t.hint} autoComplete="off"
          spellCheck={false} autoFocus={focus} value={typed} onFocus={() => search(true)} onKeyDown={onSearchKey}
          onChange={(event) => type(event.currentTarget.value)} />
      </div>
      <div className="small soft cycle-found" role="status">
        {found && best && `${t.found(found.length)} ${t.enter(nameOf(best.number))}`}
        {found && !best && beside.length === 0 && t.none}
        {beside.map(({ number, why }) => (
          <p key={number} className="field-message info">
            <Icon name="info" /> <span>{t[why](nameOf(number))}</span>
          </p>
        ))}
        {!found && (fingers ? t.languages : `${t.languages} ${t.keys}`)}
      </div>
      {found
        ? (
          <ul className="cycle-rows">
            {found.map((cycle, i) => (
              <CycleRow key={cycle.number} cycle={cycle} ways={ways} first={i === 0} grouped
                inTurn={cycle.number === (found.some(({ number }) => number === turn)
                  ? turn
                  : best?.number)} />
            ))}
          </ul>
        )
        : (
          <>
            <RecentCycles offered={cycles} ways={ways} />
            {menuGroups(cycles).map(([group, own]) => (
              <CycleGroup key={group} group={group} cycles={own} ways={ways} turn={turn} startsOpen={!narrow && !phone} />
            ))}
          </>
        )}
    </div>
  );
}
