import { useEffect, useEffectEvent, useMemo, useRef, useState, type KeyboardEvent } from "react";
import { useActions } from "../../base/actions.ts";
import { Icon } from "../../base/Icon.tsx";
import { useTexts } from "../../base/settings/use-texts.ts";
import { KEEPS_KEYBOARD } from "../../place/place.ts";
import type { TextBar } from "./text-bar.ts";
import { matchesIn, nextMatch, type Match } from "./text-search.ts";
import "./find.css";

/** A replacement in a text. */
export interface Replacement extends Match {
  readonly insert: string;
}

/** A text that can be searched. */
export interface SearchedText {
  /** The newest text. */
  readonly text: () => string;
  /** The selection, where a search begins. */
  readonly selection: () => Match;
  /** Marks every occurrence and shows this one; `isChosen`: the cursor goes there too. */
  readonly show: (sought: string, match: Match | null, isChosen: boolean) => void;
  readonly focus: () => void;
  readonly replace?: (changes: readonly Replacement[]) => void;
}

interface Props {
  readonly bar: TextBar;
  readonly of: SearchedText;
  /** Changes with the text. */
  readonly version: unknown;
}

/** The occurrence that opening the bar shows. */
function firstShown({ sought, step }: TextBar, of: SearchedText): Match | null {
  const matches = matchesIn(of.text(), sought);
  return matches[nextFrom(matches, null, of.selection(), step)] ?? null;
}

/** Index of the next or previous occurrence; with step 0 the one at the selection, or the first behind it. */
function nextFrom(matches: readonly Match[], shown: Match | null, selection: Match, step: -1 | 0 | 1): number {
  const isThere = matches.some(({ from }) => from === shown?.from);
  const { from, to } = isThere && shown ? shown : selection;
  // A cursor in front of an occurrence has not shown it yet.
  const isShown = isThere || matches.some((match) => match.from === from && match.to === to);
  return nextMatch(matches, step > 0 && isShown ? from + 1 : from, step < 0);
}

/** The line of an occurrence. */
const lineAt = (text: string, at: number): string =>
  text.slice(text.lastIndexOf("\n", at - 1) + 1).split(/\r?\n/, 1)[0] ?? "";

/** Finds and replaces in a program text. A new one is made each time it is opened. */
export function FindBar({ bar, of, version }: Props) {
  const t = useTexts("find");
  const { sought, replacement } = bar;
  const input = useRef<HTMLInputElement>(null);
  const [shown, setShown] = useState(() => firstShown(bar, of));
  const [replaced, setReplaced] = useState<number | null>(null);
  // oxlint-disable-next-line react/exhaustive-deps -- The text is read when its version changes.
  const matches = useMemo(() => matchesIn(of.text(), sought), [of, version, sought]);
  const at = shown ? matches.findIndex(({ from }) => from === shown.from) : -1;

  const show = (text: string, match: Match | null, isChosen: boolean) => {
    setShown(match);
    of.show(text, match, isChosen);
  };
  const search = (text: string) => {
    bar.search(text);
    setReplaced(null);
    const now = matchesIn(of.text(), text);
    show(text, now[nextFrom(now, null, of.selection(), 0)] ?? null, false);
  };
  const go = (step: -1 | 1) => {
    const now = matchesIn(of.text(), sought);
    setReplaced(null);
    show(sought, now[nextFrom(now, shown, of.selection(), step)] ?? null, true);
  };
  const replaceOne = () => {
    if (!shown || at < 0) return go(1);
    of.replace?.([{ ...shown, insert: replacement }]);
    const now = matchesIn(of.text(), sought);
    setReplaced(1);
    show(sought, now[nextMatch(now, shown.from + replacement.length)] ?? null, true);
  };
  const replaceAll = () => {
    const all = matchesIn(of.text(), sought);
    of.replace?.(all.map((match) => ({ ...match, insert: replacement })));
    setReplaced(all.length);
    show(sought, null, false);
  };
  const close = () => {
    if (shown && at >= 0) of.show(sought, shown, true);
    bar.close();
    of.focus();
  };
  useActions([
    { id: "text.next", isUnlisted: true, run: () => go(1) },
    { id: "text.previous", isUnlisted: true, run: () => go(-1) },
  ]);
  const begin = useEffectEvent(() => {
    of.show(sought, shown, bar.step !== 0);
    input.current?.focus();
    input.current?.select();
  });
  const clear = useEffectEvent(() => of.show("", null, false));
  useEffect(() => {
    begin();
    return () => clear();
  }, []);

  const status = () => {
    if (replaced !== null) return t.replaced(replaced);
    if (sought.trim() === "") return "";
    return at >= 0 ? t.position(at + 1, matches.length) : t.count(matches.length);
  };
  const onKey = (event: KeyboardEvent) => {
    if (event.key === "Escape") {
      event.stopPropagation();
      close();
    } else if (event.key === "Enter" && event.target === input.current) {
      event.preventDefault();
      go(event.shiftKey ? -1 : 1);
    }
  };
  const canReplace = of.replace !== undefined,
    isReplacing = canReplace && bar.mode === "replace";
  return (
    <div className="text-bar" role="search" aria-label={t.find} onKeyDown={onKey} {...{ [KEEPS_KEYBOARD]: "" }}>
      <div className="text-bar-row">
        {canReplace && (
          <button
            type="button"
            className="button icon plain"
            aria-label={t.replace}
            title={`${t.replace} (${t.ctrl}+H)`}
            aria-expanded={isReplacing}
            onClick={() => bar.open(isReplacing ? "find" : "replace")}
          >
            <Icon name={isReplacing ? "down" : "fold"} />
          </button>
        )}
        <input
          ref={input}
          type="text"
          className="input number"
          aria-label={t.find}
          placeholder={t.find}
          enterKeyHint="search"
          autoComplete="off"
          autoCapitalize="none"
          spellCheck={false}
          value={sought}
          onChange={(event) => search(event.currentTarget.value)}
        />
        <span className="small soft text-bar-count" role="status">
          {status()}
          {shown && at >= 0 && <span className="unseen">: {lineAt(of.text(), shown.from)}</span>}
        </span>
        <button
          type="button"
          className="button icon plain"
          aria-label={t.previous}
          title={`${t.previous} (${t.shift}+F3)`}
          disabled={matches.length === 0}
          onClick={() => go(-1)}
        >
          <Icon name="up" />
        </button>
        <button
          type="button"
          className="button icon plain"
          aria-label={t.next}
          title={`${t.next} (F3)`}
          disabled={matches.length === 0}
          onClick={() => go(1)}
        >
          <Icon name="down" />
        </button>
        <button type="button" className="button icon plain" aria-label={t.close} title={t.close} onClick={close}>
          <Icon name="close" />
        </button>
      </div>
      {isReplacing && (
        <div className="text-bar-row text-bar-replace">
          <input
            type="text"
            className="input number"
            aria-label={t.with}
            placeholder={t.with}
            autoComplete="off"
            autoCapitalize="none"
            spellCheck={false}
            value={replacement}
            onChange={(event) => bar.replaceWith(event.currentTarget.value)}
            onKeyDown={(event) => {
              if (event.key !== "Enter") return;
              event.preventDefault();
              replaceOne();
            }}
          />
          <button type="button" className="button" disabled={matches.length === 0} onClick={replaceOne}>
            {t.replaceOne}
          </button>
          <button type="button" className="button" disabled={matches.length === 0} onClick={replaceAll}>
            {t.replaceAll}
          </button>
        </div>
      )}
    </div>
  );
}
