import { create } from "zustand";
import type { Draft } from "../../../program/job/read-draft.ts";
import { useEditor } from "../../document/store.ts";

/** Sizes that follow from the stock for the cycle block that was inserted last: its open prompts suggest them. */
interface SuggestedSizes {
  readonly work: string | null;
  readonly index: number;
  readonly cycle: number;
  readonly sizes: Draft;
}

const useSuggested = create<SuggestedSizes>(() => ({ work: null, index: -1, cycle: 0, sizes: {} }));
const none: Draft = {};

/** Suggests sizes for the prompts of a cycle block of the open work. */
export const suggestSizes = (index: number, cycle: number, sizes: Draft): void =>
  useSuggested.setState({ work: useEditor.getState().work, index, cycle, sizes });

/** The suggested sizes of a block, by Q. */
export function useSuggestedSizes(index: number, cycle: number | null): Draft {
  const work = useEditor((s) => s.work);
  return useSuggested((s) => (s.work === work && s.index === index && s.cycle === cycle ? s.sizes : none));
}
