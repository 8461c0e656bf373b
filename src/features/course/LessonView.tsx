import { Suspense, use, useEffect, useRef, useState } from "react";
import { parameterValueIn, withParameterValue } from "../../course/playback-range.ts";
import { programOfLines } from "../../course/task-start.ts";
import type { Lesson } from "../../course/lesson.ts";
import type { LessonPage } from "../../course/progress.ts";
import { goToEntrance } from "../../app/document/go-home.ts";
import { coursePage, usePlace } from "../../app/place/place.ts";
import { clock } from "../../app/base/clock.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { createPlaybackStore } from "../../app/calculation/playback-store.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { markFulfilled } from "../../app/base/settings/loaded-texts.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { inScreenLanguage } from "../../course/words.ts";
import { fetchLesson, useCourseIndex, type LessonEntry } from "../../app/records/course/content.ts";
import { courseHref } from "../../app/place/course-links.ts";
import { LessonPicture } from "./LessonPicture.tsx";
import { LessonProgram } from "./LessonProgram.tsx";
import { LessonSlide } from "./LessonSlide.tsx";
import { LessonTasks } from "./LessonTasks.tsx";
import { pagesOf, type LessonPageOf } from "./lesson-pages.ts";
import { Paragraphs } from "./Paragraphs.tsx";
import { noteLessonPage } from "../../app/records/course/progress.ts";
import { useLessonRun } from "./use-lesson-run.ts";
import { usePageTurning } from "./use-page-turning.ts";

const pendingLessons = new Map<string, Promise<Lesson | null>>();

/** A lesson, fetched when it is first opened. */
function useLesson(id: string): Lesson | null {
  const made = pendingLessons.get(id) ?? fetchLesson(id);
  pendingLessons.set(id, made);
  markFulfilled(made);
  return use(made);
}

/** A page: its text next to the lathe, and its slider. */
function PageOfLesson({
  page,
  text,
  before,
  name,
}: {
  readonly page: LessonPageOf;
  readonly text: string;
  /** Texts of the pages before it. */
  readonly before: readonly string[];
  readonly name: string;
}) {
  const t = useTexts("course").picture;
  const { slide, program } = page;
  const [playback] = useState(() => createPlaybackStore(clock));
  const [read, setRead] = useState(false);
  const [slid, setSlid] = useState<{ readonly key: string; readonly value: number } | null>(null);
  const first = slide ? (parameterValueIn(program, slide.q) ?? slide.from) : 0;
  const value = slid?.key === page.key ? slid.value : first;
  const lines = slide ? withParameterValue(program, slide.q, value) : program;
  const { outcome, isPending, failed } = useLessonRun(programOfLines(lines));
  return (
    <>
      <div className="lesson-side">
        {outcome && (
          <LessonPicture
            outcome={outcome}
            page={page}
            playback={playback}
            waits={isPending}
            failed={failed}
            slid={slid?.key === page.key}
          />
        )}
        {!outcome && (
          <p className="lesson-waits soft" role="status">
            {failed ? t.failed : t.working}
          </p>
        )}
      </div>
      <div className="lesson-text">
        <section className="lesson-words" aria-label={name} aria-live="polite" aria-atomic="true">
          <Paragraphs text={text} before={before} />
        </section>
        {slide && (
          <LessonSlide
            slide={slide}
            value={value}
            lines={lines}
            onSlide={(next) => setSlid({ key: page.key, value: next })}
          />
        )}
        <LessonProgram
          lines={lines}
          playback={playback}
          open={read}
          onOpen={setRead}
          run={isPending || !outcome ? null : outcome.run}
        />
      </div>
    </>
  );
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

/** The previous and the next page of a lesson. */
function usePageNeighbours(entry: LessonEntry, at: LessonPage) {
  const t = useTexts("course");
  const { lessons } = useCourseIndex();
  const next = lessons[lessons.indexOf(entry) + 1];
  const after = typeof at === "number" && at < entry.pages ? at + 1 : "tasks";
  const back = at === "tasks" ? entry.pages : at - 1;
  return {
    back: back >= 1 ? { lesson: entry.id, page: back, name: t.previous } : null,
    on:
      at === "tasks"
        ? next
          ? { lesson: next.id, page: 1, name: t.nextLesson(String(next.number), next.title) }
          : null
        : { lesson: entry.id, page: after as LessonPage, name: after === "tasks" ? t.toTasks : t.next },
  };
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
    // The list of lessons is not reached by turning pages.
    if (to && to.lesson === entry.id) goToEntrance({ page: "course", lesson: to.lesson, at: to.page });
  });
  useEffect(() => noteLessonPage({ lesson: entry.id, number: entry.number, page: at }), [entry, at]);
  useEffect(() => {
    for (const each of main.current?.querySelectorAll(".lesson-body, .lesson-text") ?? []) each.scrollTop = 0;
    main.current?.scrollIntoView?.({ block: "start" });
  }, [at]);
  const words = lesson && inScreenLanguage(lesson.words, language);
  if (!lesson || !words) return <MissingLesson />;
  const page = typeof at === "number" ? pagesOf(lesson)[at - 1] : undefined;
  return (
    <main className="course-page lesson" ref={main}>
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
            page={page}
            text={words.pages[at - 1] ?? ""}
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
            <a className="button" href={courseHref(back.lesson, back.page)}>
              {back.name}
            </a>
          )}
        </span>
        <span className="soft small" aria-hidden="true">
          {typeof at === "number" && t.pageOf(String(at), String(entry.pages))}
        </span>
        <span className="lesson-foot-side">
          {on && (
            <a className="button primary" href={courseHref(on.lesson, on.page)}>
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
