import { create } from "zustand";
import { fileKey } from "../../program/state/program-files.ts";
import { useEditor } from "./store.ts";
import { filesOf, fileOf, type ProgramWork, type WorkFile } from "./work.ts";

/** Key of the file that the editor shows; null for the main program. It is a place, and no part of the work. */
const useShownKey = create<{ readonly key: string | null }>(() => ({ key: null }));

/** Shows a file of the open work; an unknown name shows the main program. */
export const showFile = (name: string | null): void =>
  useShownKey.setState({ key: name === null ? null : fileKey(name) });

const shownOf = (program: ProgramWork, key: string | null): WorkFile =>
  (key === null ? undefined : fileOf(program, key)) ?? program;

/** The file of a work whose text is shown. */
export const shownFile = (program: ProgramWork): WorkFile => shownOf(program, useShownKey.getState().key);

/** The shown file if it is not the main program, else null. */
const otherFileOf = (program: ProgramWork | null, key: string | null): WorkFile | null =>
  (program && key !== null && filesOf(program).find(({ name }) => fileKey(name) === key)) || null;

/** The shown file of the open work if it is not the main program, else null. */
export const shownOtherFile = (): WorkFile | null =>
  otherFileOf(useEditor.getState().program, useShownKey.getState().key);

/** Its name, as a hook. */
export function useShownOtherFile(): string | null {
  const key = useShownKey((s) => s.key);
  return useEditor((s) => otherFileOf(s.program, key)?.name ?? null);
}

/** Name of the shown file, as a hook. */
export function useShownName(): string {
  const key = useShownKey((s) => s.key);
  return useEditor((s) => (s.program ? shownOf(s.program, key).name : ""));
}

/** Subscribes to changes of the shown file. */
export const onShown = (listener: () => void): (() => void) => useShownKey.subscribe(listener);
