import { z } from "zod/mini";
import { record } from "../../base/record.ts";

/** Who works on this device, as last typed for an exam or a result. */
export interface Learner {
  readonly name: string;
  readonly group: string;
}

const text = z.string().check(z.maxLength(200));

/** Not part of a backup: on another device it may be another learner. */
const learnerRecord = record({
  key: "course-learner",
  version: 1,
  schema: z.object({ name: text, group: text }),
  from: ({ name, group }): Learner => ({ name, group }),
  to: (learner) => ({ ...learner }),
  first: { name: "", group: "" } as Learner,
});

export const learnerOfDevice = (): Learner => learnerRecord.now();

/** Remembers name and class for the next exam or result; an empty name forgets nothing. */
export function noteLearner({ name, group }: Learner): void {
  const learner = { name: name.trim(), group: group.trim() };
  if (learner.name !== "") learnerRecord.put(learner);
}
