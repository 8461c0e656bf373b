import { useEffect } from "react";
import { useTexts } from "../app/base/settings/use-texts.ts";
import { useEditor, openContent } from "../app/document/store.ts";
import { taskOfWork } from "../app/document/work-task.ts";
import { guidePath, shownPage, usePlace } from "../app/place/place.ts";

/** The name of the page on top; null for the course and the glossary, which name their lessons and terms themselves. */
function usePageName(): string | null {
  const { page: t, start, menu } = useTexts("first");
  const name = useEditor((s) => openContent(s)?.name ?? "");
  const isTask = useEditor((s) => taskOfWork(s) !== undefined);
  const page = usePlace((p) => shownPage(p).page);
  const isFinding = usePlace((p) => p.over?.dialog === "which");
  const [kind, of, more] = usePlace(guidePath) ?? [];
  if (isFinding) return t.start.which;
  switch (page) {
    case "tools":
      return t.tools.title;
    case "own":
      return t.own.title;
    case "works":
      return t.works.title;
    case "sheet":
      return `${t.text.setupSheet}, ${name}`;
    case "guide": {
      if (kind === "glossary") return null;
      if (of === "advice") return start.beyondAll.advice.what;
      const cycle = menu.of[Number(of)]?.name;
      return cycle === undefined ? start.doors.guide : [of, more, cycle].filter((part) => part !== undefined).join(" ");
    }
    case "plan":
      return start.doors.plan;
    case "course":
      return null;
    default:
      return page === "work" && isTask ? null : name;
  }
}

/** Gives the browser's tab the name of the page on top. */
export function useTitle(): void {
  const name = usePageName();
  useEffect(() => {
    if (name !== null) document.title = name === "" ? "Turnwise" : `${name} · Turnwise`;
  }, [name]);
}
