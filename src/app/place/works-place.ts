import { create } from "zustand";

/** Whether the list of all works stands in place of the start page. Undo does not touch it. */
export const useWorksPlace = create<{ readonly shown: boolean }>(() => ({ shown: false }));

export const hideWorks = (): void => useWorksPlace.setState({ shown: false });
