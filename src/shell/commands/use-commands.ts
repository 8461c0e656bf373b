import { useMemo } from "react";
import { keysOf, possibleActions, type Action } from "../../app/base/actions.ts";
import {
  changeSettings,
  SECTION_VIEWS,
  SHOWN_COLOURS,
  SHOWN_PATHS,
  useSettings,
} from "../../app/base/settings/settings.ts";
import { useTexts, useTextsOrNull } from "../../app/base/settings/use-texts.ts";
import { useDocumentInView } from "../../app/document/history.ts";
import { useEditor } from "../../app/document/store.ts";
import { useStepName } from "../../app/document/use-step-words.ts";
import { offeredCycles } from "../../app/fields/chooser/menu.ts";
import { noteRecent } from "../../app/fields/chooser/recent.ts";
import { openSaved } from "../../app/fields/kept/SavedPrograms.tsx";
import { printAddress, type Address } from "../../app/place/address.ts";
import { shownPage, usePlace } from "../../app/place/place.ts";
import { useCourseIndex } from "../../app/records/course/content.ts";
import { useSavedWorks } from "../../app/records/keep.ts";
import { fetchInsertCycle } from "../../features/editor/index.ts";
import { openExample } from "../../features/start/first.ts";
import { fetchBeginCycle } from "../../features/start/index.ts";
import { goTo } from "../page-address.ts";
import { choice, settingChoices, type SettingChoice } from "../setting-choices.ts";
import type { Command } from "./find-commands.ts";

/** Programs that are listed. */
const MOST_PROGRAMS = 20;

const settingCommands = (all: readonly SettingChoice[]): readonly Command[] =>
  all.flatMap(({ id, name, value, options, choose }) =>
    options
      .filter((option) => option.value !== value)
      .map((option) => ({
        id: `setting ${id} ${option.value}`,
        group: "setting" as const,
        name: `${name}: ${option.name}`,
        run: () => choose(option.value),
      })),
  );

/** A cycle starts a program of its own, or goes into the open one. */
const runCycle = (number: number, isInserted: boolean) => async (): Promise<void> => {
  noteRecent(number);
  if (isInserted) (await fetchInsertCycle()).insertCycle(number);
  else (await fetchBeginCycle()).beginCycle(number, true);
};

/** Settings of the simulation, while one is shown. */
function useViewSettings(): readonly SettingChoice[] {
  const t = useTextsOrNull("workplace")?.lathe;
  const isShown = usePlace((p) => shownPage(p).page === "work");
  const { section, solid, paths, colours } = useSettings();
  return useMemo(() => {
    if (!t || !isShown) return [];
    return [
      choice(
        "section",
        t.sections.title,
        [...SECTION_VIEWS, "solid" as const],
        t.sections,
        solid ? "solid" : section,
        (value) => changeSettings({ solid: value === "solid", ...(value !== "solid" && { section: value }) }),
      ),
      choice("paths", t.paths.title, SHOWN_PATHS, t.paths, paths, (value) => changeSettings({ paths: value })),
      choice("colours", t.colours.title, SHOWN_COLOURS, t.colours, colours, (value) =>
        changeSettings({ colours: value }),
      ),
    ];
  }, [t, isShown, section, solid, paths, colours]);
}

/** Everything that the palette offers now, in the screen language. */
export function useCommands(): readonly Command[] {
  const t = useTexts("commands");
  const { page, menu, start } = useTexts("first");
  const { does } = useTexts("keys");
  const { lessons } = useCourseIndex();
  const works = useSavedWorks((k) => k.works);
  const open = useEditor((s) => s.work);
  const isProgram = useEditor((s) => s.program !== null) && shownPage(usePlace.getState()).page === "work";
  const settings = useSettings();
  const views = useViewSettings();
  const document = useDocumentInView();
  const undo = useStepName(document, "past", page.undo);
  const redo = useStepName(document, "future", page.redo);
  return useMemo(() => {
    const texts: Readonly<Record<string, Readonly<Record<string, string>>>> = does;
    const nameOf = ({ id, name }: Action) => {
      const [place = "", key = ""] = id.split(".");
      return (id === "everywhere.undo" ? undo : id === "everywhere.redo" ? redo : name) ?? texts[place]?.[key] ?? id;
    };
    const place = (name: string, address: Address, words: readonly string[] = []): Command => ({
      id: `page ${printAddress(address)}`,
      group: "page",
      name,
      words,
      run: () => void goTo(address),
    });
    return [
      ...possibleActions()
        .filter(({ isUnlisted }) => !isUnlisted)
        .map((action): Command => {
          const [keys] = keysOf(action.id);
          return {
            id: action.id,
            group: "action",
            name: nameOf(action),
            ...(action.words && { words: action.words }),
            ...(keys !== undefined && { keys }),
            run: () => action.run(null),
          };
        }),
      place(t.start, { page: "start", which: false }),
      place(page.works.title, { page: "works" }),
      place(t.course, { page: "course", lesson: null, at: 1 }),
      place(page.tools.title, { page: "tools", number: null, milling: false }),
      place(start.doors.plan, { page: "plan" }),
      place(page.own.title, { page: "own", row: null }),
      place(t.guide, { page: "guide", path: ["guide"] }),
      place(t.glossary, { page: "guide", path: ["glossary"] }),
      ...works
        .filter(({ work }) => work !== open)
        .slice(0, MOST_PROGRAMS)
        .map(({ work, name, cycle }): Command => ({
          id: `program ${work}`,
          group: "program",
          name,
          words: cycle === null ? [] : [String(cycle)],
          run: () => void openSaved(work),
        })),
      ...offeredCycles(isProgram).map(({ number }): Command => ({
        id: `cycle ${number}`,
        group: "cycle",
        name: `${number} ${menu.of[number]?.name ?? ""}`,
        run: () => void runCycle(number, isProgram)(),
      })),
      ...lessons.map(({ id, number, title, aim }): Command => ({
        id: `lesson ${id}`,
        group: "lesson",
        name: `${number} ${title}`,
        words: [aim],
        run: () => void goTo({ page: "course", lesson: id, at: 1 }),
      })),
      ...Object.entries(page.examples).map(([id, name]): Command => ({
        id: `example ${id}`,
        group: "example",
        name,
        run: () => void openExample(id),
      })),
      ...settingCommands([...settingChoices(page, settings), ...views]),
    ];
  }, [t, page, menu, start, does, lessons, works, open, isProgram, settings, views, undo, redo]);
}
