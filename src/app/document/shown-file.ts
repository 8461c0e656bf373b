import { create } from "zustand";
import { fileKey } from "../../program/state/program-files.ts";
import { useEditor } from "./store.ts";
import { filesOf, fileOf, type ProgramWork, type WorkFile } from "./work.ts";

/**
 * Key of the file whose text the editor shows; null for the program that runs. It is a place, and no part of the work.
 */
const useShownKey = create<{ readonly key: string | null }>(() => ({ key: null }));

/** Shows the text of a file of the open work; one that it does not have shows the program. */
export const showFile = (name: string | null): void =>
  useShownKey.setState({ key: name === null ? null : fileKey(name) });

const shownOf = (program: ProgramWork, key: string | null): WorkFile =>
  (key === null ? undefined : fileOf(program, key)) ?? program;

/** The file of a work whose text is shown. */
export const shownFile = (program: ProgramWork): WorkFile => shownOf(program, useShownKey.getState().key);

/** The same while it is not the program that runs, but one of those beside it. */
const besideOf = (program: ProgramWork | null, key: string | null): WorkFile | null =>
  (program && key !== null && filesOf(program).find(({ name }) => fileKey(name) === key)) || null;

/** The file beside the program that is shown in its place; null while that is the program itself. */
export const shownBeside = (): WorkFile | null => besideOf(useEditor.getState().program, useShownKey.getState().key);

/** Its name, followed by a component. */
export function useShownBeside(): string | null {
  const key = useShownKey((s) => s.key);
  return useEditor((s) => besideOf(s.program, key)?.name ?? null);
}

/** Name of the file that is shown, followed by a component. */
export function useShownName(): string {
  const key = useShownKey((s) => s.key);
  return useEditor((s) => (s.program ? shownOf(s.program, key).name : ""));
}

/** Hears of every change of what is shown. */
export const onShown = (listener: () => void): (() => void) => useShownKey.subscribe(listener);
