import { create } from "zustand";
import { z } from "zod/mini";
import { formShape, type MadeTask } from "../../../course/made/made-form.ts";
import { time } from "../../clock.ts";
import { keepTable } from "../../saving/device-table.ts";

/** A form as it was left, a mark of the program that it was filled in from, and when, ms since 1970. */
export interface KeptForm {
  readonly form: MadeTask;
  readonly print: string;
  readonly at: number;
}
/** Forms by what they are of: a work of this device, or a kept task that is being changed. */
export type KeptForms = Readonly<Record<string, KeptForm>>;

/** Most forms that are kept; the oldest give way. */
const MOST_FORMS = 40;
const kept = z.object({
  version: z.literal(1),
  forms: z.record(z.string().check(z.maxLength(200)), z.object({ form: formShape, print: z.string(), at: z.number() })),
});

/** Kept forms; null where they are damaged. Never throws. */
export function readForms(text: string): KeptForms | null {
  try {
    const read = kept.safeParse(JSON.parse(text));
    return read.success ? read.data.forms : null;
  } catch {
    return null;
  }
}

export const writeForms = (forms: KeptForms): string | null =>
  Object.keys(forms).length === 0 ? null : JSON.stringify({ version: 1, forms });

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
    take: (list) => useForms.setState({ list }),
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

/** Keeps a form as it stands. */
export function keepForm(key: string, form: MadeTask, print: string): void {
  useForms.setState(({ list }) => {
    const all = Object.entries({ ...list, [key]: { form, print, at: time() } });
    return { list: Object.fromEntries(all.toSorted(([, a], [, b]) => b.at - a.at).slice(0, MOST_FORMS)) };
  });
}

/** Lets a form go: what it was for is done. */
export const forgetForm = (key: string): void =>
  useForms.setState(({ list }) => ({ list: Object.fromEntries(Object.entries(list).filter(([other]) => other !== key)) }));
