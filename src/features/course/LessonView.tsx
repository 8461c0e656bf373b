import { Suspense, use, useEffect, useRef } from "react";
import type { Lesson } from "../../course/lesson.ts";
import type { LessonPage } from "../../course/progress.ts";
import { goToEntrance } from "../../app/document/go-home.ts";
import { coursePage, usePlace } from "../../app/place/place.ts";
import { isFocusChosen } from "../../app/base/focus-guard.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { markFulfilled } from "../../app/base/settings/loaded-texts.ts";
import { useMedia } from "../../app/base/use-media.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { inScreenLanguage } from "../../course/words.ts";
import { fetchLesson, type LessonEntry } from "../../app/records/course/content.ts";
import { courseHref } from "../../app/place/course-links.ts";
import { PageOfLesson } from "./PageOfLesson.tsx";
import { LessonTasks } from "./LessonTasks.tsx";
import { pagesOf } from "./lesson-pages.ts";
import { noteLessonPage } from "../../app/records/course/progress.ts";
import { usePageTurning } from "./use-page-turning.ts";

const pendingLessons = new Map<string, Promise<Lesson | null>>();

/** A lesson, fetched when it is first opened. */
function useLesson(id: string): Lesson | null {
  const made = pendingLessons.get(id) ?? fetchLesson(id);
  pendingLessons.set(id, made);
  markFulfilled(made);
  return use(made);
}

/** The links to each page and to the tasks. */
function PageLinks({ entry, at }: { readonly entry: LessonEntry; readonly at: LessonPage }) {
  const t = useTexts("course");
  const all: readonly LessonPage[] = [...Array.from({ length: entry.pages }, (_, i) => i + 1), "tasks"];
  return (
    <nav className="lesson-pages" aria-label={t.pages}>
      <ol>
        {all.map((page) => (
          <li key={page}>
            <a
              className="button plain"
              href={courseHref(entry.id, page)}
              aria-current={page === at ? "page" : undefined}
              aria-label={page === "tasks" ? t.tasks : t.page(String(page))}
            >
              {page === "tasks" ? t.tasks : <span className="number">{page}</span>}
            </a>
          </li>
        ))}
      </ol>
    </nav>
  );
}

/** The previous and the next page of a lesson; its tasks, the last page, lead on by themselves. */
function usePageNeighbours(entry: LessonEntry, at: LessonPage) {
  const t = useTexts("course");
  const after = typeof at === "number" && at < entry.pages ? at + 1 : "tasks";
  const back = at === "tasks" ? entry.pages : at - 1;
  return {
    back: back >= 1 ? { page: back, name: t.previous } : null,
    on: at === "tasks" ? null : { page: after as LessonPage, name: after === "tasks" ? t.toTasks : t.next },
  };
}

/** In one column the question of a page is below its text. */
function showQuestion(lesson: HTMLElement | null): void {
  const question = lesson?.querySelector<HTMLElement>(".lesson-question");
  question?.focus({ preventScroll: true });
  question?.scrollIntoView({ block: "start" });
}

function OpenLesson({ entry }: { readonly entry: LessonEntry }) {
  const t = useTexts("course");
  const language = useSettings((s) => s.language);
  const lesson = useLesson(entry.id);
  const asked = usePlace((p) => coursePage(p)?.at ?? 1);
  const at: LessonPage = typeof asked === "number" && asked > entry.pages ? entry.pages : asked;
  const main = useRef<HTMLElement>(null);
  const { back, on } = usePageNeighbours(entry, at);
  usePageTurning(main, (by) => {
    const to = by < 0 ? back : on;
    if (to) goToEntrance({ page: "course", lesson: entry.id, at: to.page });
  });
  useEffect(() => noteLessonPage({ lesson: entry.id, number: entry.number, page: at }), [entry, at]);
  useEffect(() => {
    const { current } = main;
    if (!current) return;
    for (const each of [current, ...current.querySelectorAll(".lesson-body, .lesson-text")]) each.scrollTop = 0;
    current.scrollIntoView?.({ block: "start" });
  }, [at]);
  // What had the focus may be gone with the page before: the focus goes to the new text, or to the list of the tasks,
  // where Enter pressed again does nothing. Elsewhere, such as in the program, the arrow keys would no longer turn pages.
  const focused = useRef<Element | null>(null);
  const before = useRef(at);
  useEffect(() => {
    const isToTasks = before.current !== "tasks" && at === "tasks";
    const isLost = before.current !== at && focused.current?.isConnected === false;
    before.current = at;
    const isFree = (document.activeElement ?? document.body) === document.body || !isFocusChosen();
    if ((!isToTasks && !isLost) || !isFree) return;
    const place = main.current?.querySelector<HTMLElement>(at === "tasks" ? "#lesson-tasks" : ".lesson-words");
    place?.focus({ preventScroll: true });
  }, [at]);
  const oneColumn = useMedia("slim");
  const words = lesson && inScreenLanguage(lesson.words, language);
  if (!lesson || !words) return <MissingLesson />;
  const page = typeof at === "number" ? pagesOf(lesson)[at - 1] : undefined;
  return (
    <main className="course-page lesson" ref={main} onFocus={({ target }) => void (focused.current = target)}>
      <header className="lesson-head">
        <a className="button icon plain" href={courseHref()} aria-label={t.toList} title={t.toList}>
          <Icon name="back" />
        </a>
        <h1>
          <span className="soft">{t.lesson(String(entry.number))}</span> {words.title}
        </h1>
        <PageLinks entry={entry} at={at} />
      </header>
      <div className="lesson-body" data-tasks={!page}>
        {page && typeof at === "number" ? (
          <PageOfLesson
            lesson={entry.id}
            page={page}
            text={words.pages[at - 1] ?? ""}
            questionWords={words.questions[at - 1] ?? null}
            before={words.pages.slice(0, at - 1)}
            name={t.pageOf(String(at), String(entry.pages))}
          />
        ) : (
          <LessonTasks lesson={lesson} entry={entry} aim={words.aim} />
        )}
      </div>
      <footer className="lesson-foot">
        <span className="lesson-foot-side">
          {back && (
            <a className="button" href={courseHref(entry.id, back.page)}>
              {back.name}
            </a>
          )}
        </span>
        {oneColumn && page?.question ? (
          <button type="button" className="button plain" onClick={() => showQuestion(main.current)}>
            {t.question.name}
          </button>
        ) : (
          <span className="soft small" aria-hidden="true">
            {typeof at === "number" && t.pageOf(String(at), String(entry.pages))}
          </span>
        )}
        <span className="lesson-foot-side">
          {on && (
            <a className="button primary" href={courseHref(entry.id, on.page)}>
              {on.name}
            </a>
          )}
        </span>
      </footer>
    </main>
  );
}

function MissingLesson() {
  const t = useTexts("course");
  return (
    <main className="course-page">
      <p>{t.missing}</p>
      <p>
        <a className="button" href={courseHref()}>
          {t.toList}
        </a>
      </p>
    </main>
  );
}

/** A lesson: its pages in order, then its tasks. */
export function LessonView({ entry }: { readonly entry: LessonEntry | null }) {
  return entry ? (
    <Suspense>
      <OpenLesson entry={entry} />
    </Suspense>
  ) : (
    <MissingLesson />
  );
}
