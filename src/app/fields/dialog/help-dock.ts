import { create } from "zustand";

/** A pane of the view that another part of the page may fill through a portal. */
interface Dock {
  /** Null where the page has no such pane. */
  readonly dock: HTMLElement | null;
  readonly filled: boolean;
}

function createDock() {
  const use = create<Dock>(() => ({ dock: null, filled: false }));
  return {
    use,
    /** Ref of the pane. */
    hold: (dock: HTMLElement | null): void => use.setState({ dock }),
    /** Marks the pane as filled. Returns the function that clears the mark. */
    fill: () => {
      use.setState({ filled: true });
      return () => use.setState({ filled: false });
    },
  };
}

/** For help pictures: without a pane they are shown among the prompts. */
export const { use: useHelpDock, hold: holdHelpDock, fill: fillHelpDock } = createDock();
/** For the drawing of an exercise: a second picture in place of the lathe, or beside it where there is room. */
export const { use: useDrawingDock, hold: holdDrawingDock, fill: fillDrawingDock } = createDock();

/** Whether the picture is enlarged where it is a strip. A prompt or a section that opens puts it away. */
export const useLargePicture = create<{ readonly large: boolean }>(() => ({ large: false }));
export const enlargePicture = (large: boolean): void => useLargePicture.setState({ large });
