import { z } from "zod/mini";
import { formShape, type MadeTask } from "../../../course/made/made-form.ts";

/** A form as it was left, a mark of the program that it was filled in from, and when, ms since 1970. */
export interface KeptForm {
  readonly form: MadeTask;
  readonly print: string;
  readonly at: number;
}
/** Forms by what they are of: a work of this device, or a kept task that is being changed. */
export type KeptForms = Readonly<Record<string, KeptForm>>;

/** Most forms that are kept; the oldest give way. */
export const MOST_FORMS = 40;
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
