import { useMemo } from "react";
import { Icon } from "../../base/Icon.tsx";
import { useTexts } from "../../base/settings/use-texts.ts";
import { FindBar, type SearchedText } from "./FindBar.tsx";
import type { TextBar } from "./text-bar.ts";
import type { Match } from "./text-search.ts";

interface Props {
  readonly bar: TextBar;
  readonly text: string;
  readonly mark: (sought: string, shown: Match | null) => void;
  /** Gives the focus to the text. */
  readonly focus: () => void;
}

/** Finds in a program text that is only read. */
export function PrintedSearch({ bar, text, mark, focus }: Props) {
  const of = useMemo<SearchedText>(
    () => ({ text: () => text, selection: () => ({ from: 0, to: 0 }), show: mark, focus }),
    [text, mark, focus],
  );
  return <FindBar key={bar.opened} bar={bar} of={of} version={text} />;
}

export function FindButton({ bar }: Pick<Props, "bar">) {
  const t = useTexts("find");
  return (
    <button
      type="button"
      className="button icon plain"
      aria-label={t.find}
      title={`${t.find} (${t.ctrl}+F)`}
      onClick={() => bar.open("find")}
    >
      <Icon name="search" />
    </button>
  );
}
