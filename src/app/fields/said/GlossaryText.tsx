import { readJson } from "../../../program/files/bounded.ts";
import { createContext, Fragment, useContext, useMemo, type ReactNode } from "react";
import type { GlossaryTexts, TermId } from "../../../i18n/glossary-text.ts";
import { showGuide } from "../../place/place.ts";
import { termParts, type TermPart } from "./term-parts.ts";
import { useTextsOrNull } from "../../base/settings/use-texts.ts";
import "./terms.css";

interface Scope {
  readonly of: ReadonlyMap<string, readonly TermPart[]>;
  readonly glossary: GlossaryTexts;
}

const PageTerms = createContext<Scope | null>(null);

const scopeOf = (
  texts: readonly string[],
  glossary: GlossaryTexts,
  before: readonly string[],
  but: TermId | null,
): Scope => {
  const parts = termParts(texts, glossary, { before, but });
  return { glossary, of: new Map(texts.map((text, i) => [text, parts[i] ?? []])) };
};

/** The texts of a page in reading order; each glossary term is linked at its first use. */
export function GlossaryScope({
  texts,
  before,
  but = null,
  children,
}: {
  readonly texts: readonly string[];
  /** Texts of previous pages, whose terms are not linked again. */
  readonly before?: readonly string[];
  /** Term that the texts themselves explain. */
  readonly but?: TermId | null;
  readonly children: ReactNode;
}) {
  const glossary = useTextsOrNull("glossary");
  const all = JSON.stringify([texts, before ?? []]);
  const scope = useMemo(() => {
    const [now, earlier] = readJson(all) as readonly [string[], string[]];
    return glossary && scopeOf(now, glossary, earlier, but);
  }, [glossary, all, but]);
  return <PageTerms value={scope}>{children}</PageTerms>;
}

/** Link from a term to its glossary entry. */
function TermLink({ term, text, meaning }: { readonly term: TermId; readonly text: string; readonly meaning: string }) {
  return (
    <a
      className="term"
      href={`#/glossary/${term}`}
      title={meaning}
      onClick={(event) => {
        event.preventDefault();
        showGuide("glossary", term);
      }}
    >
      {text}
    </a>
  );
}

/** A text of the surrounding page with glossary links; `plain` renders the rest. */
export function GlossaryText({ text, plain }: { readonly text: string; readonly plain?: (text: string) => ReactNode }) {
  const scope = useContext(PageTerms),
    parts = scope?.of.get(text);
  if (!scope || !parts) return plain ? plain(text) : text;
  return parts.map(({ text: piece, term }, i) =>
    term === null ? (
      <Fragment key={i}>{plain ? plain(piece) : piece}</Fragment>
    ) : (
      <TermLink key={i} term={term} text={piece} meaning={scope.glossary[term].text} />
    ),
  );
}

/** Texts of the surrounding page as a list. */
export const GlossaryList = ({
  texts,
  className,
}: {
  readonly texts: readonly string[];
  readonly className?: string;
}) => (
  <ul className={className}>
    {texts.map((text) => (
      <li key={text}>
        <GlossaryText text={text} />
      </li>
    ))}
  </ul>
);
