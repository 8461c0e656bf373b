import type { Program } from "../../nc/program.ts";
import { changeOfBlocks, type Change, type ChangedValue, type ChangeSubject } from "./change.ts";

/** So many changes of one value are offered one by one; more of them only together. */
const MOST_APART = 3;

const keyOf = ({ subject: { kind, tool, cycle, value } }: Change): string =>
  JSON.stringify([kind, tool, cycle, value?.at, kind === "otherChoice" ? value?.to : null]);

/** The range of several changes of one value. */
function rangeOf(values: readonly ChangedValue[]): ChangedValue {
  const [from, to] = [values.map((each) => each.from), values.map((each) => each.to)];
  const most = values.flatMap((each) => each.most ?? []);
  const upTo = { from: Math.max(...from), to: Math.max(...to) };
  return {
    at: values[0]?.at ?? "",
    from: Math.min(...from),
    to: Math.min(...to),
    ...(most.length > 0 && { most: Math.max(...most) }),
    upTo,
  };
}

/** Changes of one value in many operations, made together: a long program has one of them and not a hundred. */
export function together(program: Program, changes: readonly Change[]): readonly Change[] {
  const alike = new Map<string, Change[]>();
  for (const change of changes) {
    if (!change.replaced || !change.subject.value) continue;
    const key = keyOf(change);
    const group = alike.get(key);
    if (group) group.push(change);
    else alike.set(key, [change]);
  }
  return [...alike.values()]
    .filter((group) => group.length > MOST_APART)
    .map((group) => {
      const [first] = group;
      const units = group.flatMap(({ subject }) => subject.units).toSorted((a, b) => a - b);
      const value = rangeOf(group.flatMap(({ subject }) => subject.value ?? []));
      const expected = group.reduce((sum, each) => sum + each.expected, 0);
      return changeOfBlocks(
        program,
        { ...(first?.subject as ChangeSubject), units, value },
        expected,
        group.flatMap(({ replaced = [] }) => replaced),
      );
    });
}
