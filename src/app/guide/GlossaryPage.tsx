import { useEffect, useRef, useState } from "react";
import { TERMS } from "../../i18n/glossary-text.ts";
import { useSettings } from "../settings/settings.ts";
import { useGlossary } from "./use-glossary.ts";
import { useGuideTexts } from "./use-guide-texts.ts";

/** A text as it is sought: small letters, no accents. */
const plain = (text: string) => text.normalize("NFD").replaceAll(/\p{M}/gu, "").toLowerCase();

/** All words with what they mean, those that match what is typed; one of them may be asked for by the address. */
export function GlossaryPage({ term }: { readonly term: string | null }) {
  const { glossary: t } = useGuideTexts();
  const words = useGlossary();
  const language = useSettings((s) => s.language);
  const [sought, seek] = useState("");
  const asked = useRef<HTMLDivElement>(null);
  useEffect(() => {
    asked.current?.scrollIntoView?.({ block: "center" });
    asked.current?.focus();
  }, [term]);
  const all = TERMS.map((id) => ({ id, ...words[id] })).sort((a, b) => a.name.localeCompare(b.name, language));
  const found = all.filter(({ name, text }) => plain(`${name} ${text}`).includes(plain(sought.trim())));
  const byName = found.toSorted((a, b) => Number(plain(b.name).includes(plain(sought))) - Number(plain(a.name).includes(plain(sought))));
  return (
    <>
      <header className="guide-head">
        <h1>{t.title}</h1>
        <p>{t.lead}</p>
        <label className="glossary-search">
          <span>{t.search}</span>
          <input type="search" className="input" value={sought} onChange={(event) => seek(event.currentTarget.value)} />
        </label>
        <p className="soft small" role="status">{found.length === 0 ? t.none : t.found(found.length)}</p>
      </header>
      <dl className="glossary-list">
        {byName.map(({ id, name, text }) => (
          <div key={id} data-asked={id === term || undefined} {...(id === term && { ref: asked, tabIndex: -1 })}>
            <dt>{name}</dt>
            <dd>{text}</dd>
          </div>
        ))}
      </dl>
    </>
  );
}
