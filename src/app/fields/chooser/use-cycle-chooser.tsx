import { useMemo, useRef, useState, type FocusEvent, type KeyboardEvent, type ReactNode } from "react";
import { Message } from "../../base/Message.tsx";
import { useTexts } from "../../base/settings/use-texts.ts";
import { useMedia } from "../../base/use-media.ts";
import { CycleGroup } from "./CycleGroup.tsx";
import { CycleRow, type CycleWay } from "./CycleRow.tsx";
import { onChooserKey } from "./chooser-keys.ts";
import { unofferedCycles, menuGroups, offeredCycles } from "./menu.ts";
import { noteRecent } from "./recent.ts";
import { RecentCycles } from "./RecentCycles.tsx";
import { findCycles, findUnoffered, isNamed } from "./search.ts";
import { useMenuWords } from "./use-menu-words.ts";
import "./chooser.css";

/** Rows besides the catalogue: those that match the search (null: all). `isFirst`: Enter takes the best of them. */
export type OtherRows = (
  sought: string | null,
  turn: number | null,
  isFirst: boolean,
) => {
  readonly count: number;
  readonly best: { readonly name: string; readonly go: () => void } | null;
  /** The best of them goes before a cycle that has the typed words in its description only. */
  readonly isNamed?: boolean;
  readonly shown: ReactNode;
};

/** What a chooser offers, and how it is shown. */
export interface ChooserOptions {
  readonly ways: readonly CycleWay[];
  /** Next to other content: one column, groups collapsed. */
  readonly narrow?: boolean;
  /** The chosen cycle is inserted into a program. */
  readonly inProgram?: boolean;
  /** Lists only some cycles; the search finds all of them. */
  readonly among?: (cycle: number) => boolean;
  /** Focuses the search at once. */
  readonly focus?: boolean;
  readonly more?: OtherRows;
  /** Label of a search that finds more than cycles. */
  readonly search?: string;
  /** Shown under the search while nothing is typed. */
  readonly hint?: string;
}

/** The parts of a chooser, for pages that show something between them. */
export interface CycleChooserParts {
  /** Keys and focus of the element around all parts. */
  readonly keys: {
    readonly "data-keys": "cycles";
    readonly onKeyDown: (event: KeyboardEvent<HTMLElement>) => void;
    readonly onFocus: (event: FocusEvent<HTMLElement>) => void;
  };
  /** The search field and its status. */
  readonly search: ReactNode;
  /** The cycles that the search found; null while nothing is typed. */
  readonly found: ReactNode;
  /** The search found something, here or among the other rows. */
  readonly finds: boolean;
  readonly recent: ReactNode;
  /** All cycles in their groups. */
  readonly groups: ReactNode;
  /** Rows besides the catalogue. */
  readonly others: ReactNode;
  /** Enter takes one of the other rows: they go before the cycles. */
  readonly startsWithOthers: boolean;
}

/** All cycles in the groups of the control, with search and the last used ones. */
export function useCycleChooser({
  ways: given,
  narrow = false,
  inProgram = false,
  among,
  focus = false,
  more,
  search: searchName,
  hint,
}: ChooserOptions): CycleChooserParts {
  const {
    chooser: t,
    page: { start },
    menu: names,
  } = useTexts("first");
  const phone = useMedia("slim");
  const [typed, type] = useState("");
  const [searching, search] = useState(false);
  const [turn, giveTurn] = useState<number | null>(null);
  const words = useMenuWords(searching);
  const sought = typed.trim();
  const cycles = useMemo(() => offeredCycles(inProgram), [inProgram]);
  const listed = among ? cycles.filter(({ number }) => among(number)) : cycles;
  const verified = cycles.filter(({ recalled }) => !recalled).map(({ number }) => number);
  const found = useMemo(() => (sought === "" ? null : findCycles(cycles, sought, words)), [cycles, sought, words]);
  const others = more?.(found && sought, turn, found?.length === 0);
  const count = (found?.length ?? 0) + (others?.count ?? 0);
  const beside = useMemo(
    () => (found && count === 0 ? findUnoffered(unofferedCycles(inProgram), sought, words) : []),
    [found, count, inProgram, sought, words],
  );
  const input = useRef<HTMLInputElement>(null);
  const ways = given.map((way): CycleWay => ({
    ...way,
    go: (cycle) => {
      noteRecent(cycle);
      way.go(cycle);
    },
  }));
  const nameOf = (cycle: number) => start.cycle(cycle, names.of[cycle]?.name ?? names.kept[cycle] ?? "");
  const best = found?.[0];
  const isOther = Boolean(others?.best && (!best || (others.isNamed && !isNamed(best.number, sought, words))));
  const taken = best && !isOther ? { name: nameOf(best.number), go: () => ways[0]?.go(best.number) } : others?.best;

  const onSearchKey = (event: KeyboardEvent) => {
    if (event.key === "Enter" && found && taken) {
      event.preventDefault();
      taken.go();
    } else if (event.key === "Escape" && typed !== "") {
      event.stopPropagation();
      type("");
    }
  };
  return {
    keys: {
      "data-keys": "cycles",
      onKeyDown: (event) => onChooserKey(event, input.current),
      onFocus: ({ target }) => {
        const row = target.closest<HTMLElement>(".cycle-row");
        if (row) giveTurn(Number(row.dataset["cycle"]));
      },
    },
    search: (
      <>
        <div className="cycle-search">
          <input
            ref={input}
            type="search"
            className="cycle-search-field"
            aria-label={searchName ?? t.search}
            placeholder={t.hint}
            autoComplete="off"
            spellCheck={false}
            autoFocus={focus}
            value={typed}
            onFocus={() => search(true)}
            onKeyDown={onSearchKey}
            onChange={(event) => type(event.currentTarget.value)}
          />
        </div>
        <div className="small soft cycle-found" role="status">
          {found && taken && `${(others?.count ? start.found : t.found)(count)} ${t.enter(taken.name)}`}
          {found && !taken && beside.length === 0 && t.none}
          {beside.map(({ number, why }) => (
            <Message key={number} tone="info">
              {t[why](nameOf(number))}
            </Message>
          ))}
          {!found && (hint ?? t.languages)}
        </div>
      </>
    ),
    found: found && (
      <ul className="cycle-rows">
        {found.map((cycle, i) => (
          <CycleRow
            key={cycle.number}
            cycle={cycle}
            ways={ways}
            first={i === 0 && !isOther}
            grouped
            inTurn={cycle.number === (found.some(({ number }) => number === turn) ? turn : best?.number)}
          />
        ))}
      </ul>
    ),
    finds: count > 0,
    recent: <RecentCycles offered={listed} ways={ways} />,
    groups: (
      <>
        {menuGroups(listed).map(([group, own]) => (
          <CycleGroup key={group} group={group} cycles={own} ways={ways} turn={turn} startsOpen={!narrow && !phone} />
        ))}
        <p className="small soft cycle-evidence">
          {t.evidence(verified.join(", "))} <a href="#/guide">{t.evidenceLink}</a>
        </p>
      </>
    ),
    others: others?.shown,
    startsWithOthers: isOther,
  };
}
