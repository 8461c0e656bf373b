import { create } from "zustand";

/** A work that was asked for here and that another tab has: it was open there, or that tab took it from this one. */
export interface WorkElsewhere {
  readonly work: string;
  readonly name: string;
  readonly cause: "isOpen" | "wasTaken";
}

/** Null while nothing of that kind is shown. */
export const useElsewhere = create<{ readonly shown: WorkElsewhere | null }>(() => ({ shown: null }));

export const showElsewhere = (shown: WorkElsewhere | null): void => {
  if (shown !== useElsewhere.getState().shown) useElsewhere.setState({ shown });
};
