import { z } from "zod/mini";
import { moment } from "../../../program/files/bounded.ts";
import { formShape, type TaskForm } from "../../../course/made/task-form.ts";
import { time } from "../../base/clock.ts";
import { record } from "../../base/record.ts";
import { COURSE } from "../../document/documents.ts";

/** A form as it was left, the fingerprint of its program, and when, ms since 1970. */
export interface KeptForm {
  readonly form: TaskForm;
  readonly print: string;
  readonly at: number;
}
/** Forms by source: a work of this device, or a saved task that is being edited. */
export type KeptForms = Readonly<Record<string, KeptForm>>;

/** Most forms kept; the oldest are dropped. */
const MOST = 40;
const form = z.object({ form: formShape, print: z.string(), at: moment });
const NONE: KeptForms = {};

/** Forms being filled in on this device, so that closing one or reloading loses nothing. */
export const formRecord = record({
  key: "course-forms",
  version: 1,
  schema: z.object({ forms: z.record(z.string().check(z.maxLength(200)), form) }),
  rows: { of: "forms", each: form },
  from: ({ forms }): KeptForms => forms,
  to: (forms) => ({ forms }),
  first: NONE,
  document: COURSE,
});
export const useForms = formRecord.use;

const OF_WORK = "work ";
export const keyOfWork = (work: string): string => OF_WORK + work;
export const keyOfTask = (id: string): string => `task ${id}`;

export const keptForm = (key: string): KeptForm | undefined => {
  const list = formRecord.now();
  return Object.hasOwn(list, key) ? list[key] : undefined;
};

const newest = (list: KeptForms): KeptForms =>
  Object.fromEntries(
    Object.entries(list)
      .toSorted(([, a], [, b]) => b.at - a.at)
      .slice(0, MOST),
  );

/** Saves the current state of a form. */
export const keepForm = (key: string, form: TaskForm, print: string): void =>
  formRecord.put(newest({ ...formRecord.now(), [key]: { form, print, at: time() } }));

/** Deletes a form that is done. */
export const forgetForm = (key: string): void =>
  formRecord.put(Object.fromEntries(Object.entries(formRecord.now()).filter(([other]) => other !== key)));

/**
 * Forms of this device, plus the missing ones of another. `nameHere`: name here of a work that had another name there.
 */
export function mergedForms(mine: KeptForms, brought: KeptForms, nameHere: ReadonlyMap<string, string>): KeptForms {
  const keyHere = (key: string) => {
    const name = key.startsWith(OF_WORK) ? nameHere.get(key.slice(OF_WORK.length)) : undefined;
    return name === undefined ? key : keyOfWork(name);
  };
  return newest({ ...Object.fromEntries(Object.entries(brought).map(([key, form]) => [keyHere(key), form])), ...mine });
}
