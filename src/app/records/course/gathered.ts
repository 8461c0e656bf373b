import { create } from "zustand";
import { keepTable } from "../../base/device-table.ts";
import { noteChange } from "../../document/steps.ts";
import { MOST_GATHERED, readGathered, writeGathered } from "./result-list.ts";
import { isAmong, type LearnerFile } from "./result-rows.ts";

/** The results of learners that were opened on this device, in the order in which they came. */
export interface Gathered {
  readonly list: readonly LearnerFile[];
  /** False where the browser does not keep them. */
  readonly isKept: boolean;
}

export const useGathered = create<Gathered>(() => ({ list: [], isKept: true }));

const put = (list: readonly LearnerFile[]): void => useGathered.setState({ list });
const KEY = "turnwise/course-results";
let keeps = false;

/** Reads the gathered results and keeps each change from now on, in all tabs. Asked again it does nothing. */
export function startGathered(): void {
  if (keeps) return;
  keeps = true;
  keepTable<readonly LearnerFile[]>({
    key: KEY,
    aside: `${KEY}/damaged`,
    store: useGathered,
    first: [],
    isSame: (one, other) => writeGathered(one) === writeGathered(other),
    write: writeGathered,
    read: readGathered,
    take: put,
    damaged: () => undefined,
    notKept: () => useGathered.setState({ isKept: false }),
  });
}

/** Puts results beside those that are there; what goes can be taken back. */
export function gather(files: readonly LearnerFile[]): void {
  if (files.length > 0) put([...useGathered.getState().list, ...files].slice(-MOST_GATHERED));
}

function change(to: readonly LearnerFile[]): void {
  const { list } = useGathered.getState();
  put(to);
  noteChange(put, list, to);
}

/** Lets one file, or all of them, go from the table. */
export const dropGathered = (gone: LearnerFile | null): void =>
  change(gone === null ? [] : useGathered.getState().list.filter((each) => each !== gone));

/** Takes results of another device that are not here, as one step. */
export function bringGathered(brought: readonly LearnerFile[]): void {
  const { list } = useGathered.getState(), fresh = brought.filter(({ result }) => !isAmong(list, result));
  if (fresh.length > 0) change([...list, ...fresh].slice(-MOST_GATHERED));
}
