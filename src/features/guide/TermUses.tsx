import { useEffect, useState } from "react";
import type { ParamTextId } from "../../cycles/index.ts";
import type { GlossaryTexts, TermId } from "../../i18n/glossary-text.ts";
import type { Language } from "../../i18n/languages.ts";
import { inScreenLanguage } from "../../course/words.ts";
import { fetchLesson, useCourseIndex, type LessonEntry } from "../../app/records/course/content.ts";
import { courseHref } from "../../app/place/course-links.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { setupPageWords } from "./setup-page-words.ts";
import { usesTerm, usingParameters, usingSetupPages } from "./term-uses.ts";
import { untilGone } from "../../app/base/until-gone.ts";

/** A page of a lesson that uses a word first. */
interface UsingLesson {
  readonly entry: LessonEntry;
  readonly page: number;
}

/** The lessons that use a term, each with the first page that does; loaded one after the other. */
function useLessons(term: TermId, glossary: GlossaryTexts, language: Language): readonly UsingLesson[] {
  const { lessons } = useCourseIndex();
  const [found, find] = useState<readonly UsingLesson[]>([]);
  useEffect(
    () =>
      untilGone(async (isGone) => {
        for (const entry of lessons) {
          const lesson = await fetchLesson(entry.id).catch(() => null);
          if (isGone()) return;
          const pages = lesson ? (inScreenLanguage(lesson.words, language)?.pages ?? []) : [];
          const at = pages.findIndex((text) => usesTerm([text], term, glossary));
          if (at >= 0) find((was) => [...was.filter((each) => each.entry.id !== entry.id), { entry, page: at + 1 }]);
        }
      }),
    [lessons, term, glossary, language],
  );
  return found;
}

/** Where a term is used: the parameter pages with it, the set-up, and the lessons. */
export function TermUses({ term }: { readonly term: TermId }) {
  const { glossary: t } = useTexts("guide");
  const texts = useTexts();
  const places = useTexts("guide-places");
  const glossary = useTexts("glossary");
  const language = useSettings((s) => s.language);
  const lessons = useLessons(term, glossary, language);
  const parameters = usingParameters(term),
    setup = usingSetupPages(term, places, glossary);
  if (parameters.length + setup.length + lessons.length === 0) return null;
  return (
    <section className="term-uses" aria-label={t.used}>
      <h2>{t.used}</h2>
      <ul>
        {parameters.map(({ cycle, q, text }) => (
          <li key={text}>
            <a href={`#/guide/${cycle}/${q}`}>
              <b className="number">{q}</b> {texts.params[text as ParamTextId].label}
            </a>
          </li>
        ))}
        {setup.map((id) => (
          <li key={id}>
            <a href={`#/guide/setup/${id}`}>
              <b className="number">{setupPageWords(texts, id).letter}</b> {setupPageWords(texts, id).name}
            </a>
          </li>
        ))}
        {lessons.map(({ entry, page }) => (
          <li key={entry.id}>
            <a href={courseHref(entry.id, page)}>{t.lesson(String(entry.number), entry.title)}</a>
          </li>
        ))}
      </ul>
    </section>
  );
}
