import { useEffect, useRef, useState, type KeyboardEvent } from "react";
import { TERMS, type TermId } from "../../i18n/glossary-text.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { showGuide } from "../../app/place/place.ts";
import { GlossaryText, GlossaryScope } from "../../app/fields/said/GlossaryText.tsx";
import { TermUses } from "./TermUses.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** A text normalized for search: lower case, no accents. */
const plain = (text: string) => text.normalize("NFD").replaceAll(/\p{M}/gu, "").toLowerCase();

/** All terms that match the search, with their meanings; the term in the address also shows where it is used. */
export function GlossaryPage({ term }: { readonly term: string | null }) {
  const { glossary: t } = useTexts("guide");
  const words = useTexts("glossary");
  const language = useSettings((s) => s.language);
  const [sought, seek] = useState("");
  const asked = useRef<HTMLDivElement>(null);
  useEffect(() => {
    asked.current?.focus();
  }, [term]);
  const name = term !== null && Object.hasOwn(words, term) ? words[term as TermId].name : null;
  const title = [name, t.title, "Turnwise"].filter((part) => part !== null).join(" · ");
  useEffect(() => {
    document.title = title;
  }, [title]);
  const all = TERMS.map((id) => ({ id, ...words[id] })).sort((a, b) => a.name.localeCompare(b.name, language));
  const found = all.filter(({ name, text }) => plain(`${name} ${text}`).includes(plain(sought.trim())));
  const byName = found.toSorted(
    (a, b) => Number(plain(b.name).includes(plain(sought))) - Number(plain(a.name).includes(plain(sought))),
  );
  const shown = byName.toSorted((a, b) => Number(b.id === term) - Number(a.id === term));
  const onKey = (event: KeyboardEvent) => {
    const [first] = byName;
    if (event.key !== "Enter" || sought.trim() === "" || !first) return;
    event.preventDefault();
    if (first.id === term) asked.current?.focus();
    else showGuide("glossary", first.id);
  };
  return (
    <>
      <header className="guide-head">
        <h1>{t.title}</h1>
        <p>{t.lead}</p>
        <label className="glossary-search">
          <span>{t.search}</span>
          <input
            type="search"
            className="input"
            value={sought}
            onChange={(event) => seek(event.currentTarget.value)}
            onKeyDown={onKey}
          />
        </label>
        <p className="soft small" role="status">
          {found.length === 0 ? t.none : t.found(found.length)}
        </p>
      </header>
      <dl className="glossary-list">
        {shown.map(({ id, name, text }) => (
          <div key={id} data-asked={id === term || undefined} {...(id === term && { ref: asked, tabIndex: -1 })}>
            <dt>
              {id === term ? (
                name
              ) : (
                <button type="button" className="glossary-word" onClick={() => showGuide("glossary", id)}>
                  {name}
                </button>
              )}
            </dt>
            <dd>
              {id === term ? (
                <GlossaryScope texts={[text]} but={id}>
                  <GlossaryText text={text} />
                </GlossaryScope>
              ) : (
                text
              )}
            </dd>
            {id === term && (
              <dd>
                <TermUses key={id} term={id as TermId} />
              </dd>
            )}
          </div>
        ))}
      </dl>
    </>
  );
}
