import { create } from "zustand";
import type { MadeTask } from "../../../course/made/made-form.ts";
import { time } from "../../base/clock.ts";
import { keepTable } from "../../base/device-table.ts";
import { noteChange } from "../../document/steps.ts";
import { MOST_FORMS, readForms, writeForms, type KeptForm, type KeptForms } from "./form-list.ts";

/** The forms that are filled in on this device: one that is closed, or lost with its page, loses nothing. */
export const useForms = create<{ readonly list: KeptForms; readonly isKept: boolean }>(() => ({ list: {}, isKept: true }));

const KEY = "turnwise/course-forms";
let keeps = false;

/** Reads the kept forms and keeps each change from now on. Asked again it does nothing. */
export function startForms(): void {
  if (keeps) return;
  keeps = true;
  keepTable<KeptForms>({
    key: KEY,
    aside: `${KEY}/damaged`,
    store: useForms,
    first: {},
    isSame: (one, other) => writeForms(one) === writeForms(other),
    write: writeForms,
    read: readForms,
    take: put,
    damaged: () => undefined,
    notKept: () => useForms.setState({ isKept: false }),
  });
}

export const keyOfWork = (work: string): string => `work ${work}`;
export const keyOfTask = (id: string): string => `task ${id}`;

export const keptForm = (key: string): KeptForm | undefined => {
  const { list } = useForms.getState();
  return Object.hasOwn(list, key) ? list[key] : undefined;
};

const newest = (list: KeptForms): KeptForms =>
  Object.fromEntries(Object.entries(list).toSorted(([, a], [, b]) => b.at - a.at).slice(0, MOST_FORMS));

/** Keeps a form as it stands. */
export function keepForm(key: string, form: MadeTask, print: string): void {
  useForms.setState(({ list }) => ({ list: newest({ ...list, [key]: { form, print, at: time() } }) }));
}

/** Lets a form go: what it was for is done. */
export const forgetForm = (key: string): void =>
  useForms.setState(({ list }) => ({ list: Object.fromEntries(Object.entries(list).filter(([other]) => other !== key)) }));

const put = (list: KeptForms): void => useForms.setState({ list });

/** Forms of another device that this one does not have. `nameHere`: what a work is called here that had another name there. */
export const missingForms = (brought: KeptForms, mine: KeptForms, nameHere: ReadonlyMap<string, string> = new Map()): KeptForms =>
  Object.fromEntries(
    Object.entries(brought).map(([key, form]) => [nameHere.get(key) ?? key, form] as const).filter(([key]) => !Object.hasOwn(mine, key)),
  );

/** Takes forms of another device beside those that are here, as one step. */
export function bringForms(brought: KeptForms, nameHere: ReadonlyMap<string, string>): void {
  const { list } = useForms.getState(), fresh = missingForms(brought, list, nameHere);
  if (Object.keys(fresh).length === 0) return;
  const next = newest({ ...fresh, ...list });
  put(next);
  noteChange(put, list, next);
}
