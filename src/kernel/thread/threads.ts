import { buttress } from "./buttress.ts";
import { metric } from "./metric.ts";
import type { NamedThread } from "./named-thread.ts";
import { npt, pipe, taperPipe } from "./pipe.ts";
import { round } from "./round-thread.ts";
import type { ThreadStandard } from "./standard.ts";
import { trapezoidal } from "./trapezoidal.ts";
import { comparable, typedName } from "./typed-name.ts";
import { unified } from "./unified.ts";
import { whitworth } from "./whitworth.ts";

/** Every standard that names threads. A new one is one file and one entry here. */
export const THREAD_STANDARDS: readonly ThreadStandard[] = [
  metric,
  pipe,
  taperPipe,
  npt,
  trapezoidal,
  unified,
  whitworth,
  buttress,
  round,
];

export const standardOf = ({ standard }: Pick<NamedThread, "standard">): ThreadStandard =>
  THREAD_STANDARDS.find(({ id }) => id === standard) ?? metric;

/** The thread that a name says, however it is written; null for no thread. Never throws; long texts are cut. */
export function readThread(text: string): NamedThread | null {
  const typed = typedName(text);
  for (const standard of THREAD_STANDARDS) {
    const found = standard.read(typed);
    if (found) return found;
  }
  return null;
}

/** Names of the tables, with their forms for comparison: as written, and with the symbol in front. */
const names = THREAD_STANDARDS.flatMap((standard) =>
  standard.names.map((name) => {
    const plain = comparable(name);
    return { standard, name, forms: [plain, plain.replace(/^(.*\d)([a-z]+)$/, "$2$1")] };
  }),
);

/** Threads whose name is or begins with the typed text, the one that is meant first; at most `most`. */
export function threadsNamed(text: string, most: number): readonly NamedThread[] {
  const asked = comparable(text);
  if (asked === "") return [];
  const exact = readThread(text);
  const found: NamedThread[] = exact ? [exact] : [];
  for (const { standard, name, forms } of names) {
    if (found.length >= most) break;
    if (!forms.some((form) => form.startsWith(asked))) continue;
    const thread = standard.read(typedName(name));
    if (thread && !found.some((each) => each.standard === thread.standard && each.name === thread.name))
      found.push(thread);
  }
  return found;
}
